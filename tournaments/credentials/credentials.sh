#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the credentials of the processes of a league in DDS secure mode, with openssl. `mirocup league credentials` calls it.
# Usage: credentials.sh FOLDER DAYS [team NAME | revoke NAME]...
# A team whose credentials cannot be made does not stop those of the others; then the exit code is 1.
#
# FOLDER/authority   the two certificate authorities; their keys can certify any identity, so they never leave the host's computer
# FOLDER/server      for `mirocup match --credentials`; teams/NAME.pem is each team's certificate, which says when it expires
# FOLDER/spectator   for programs that only read
# FOLDER/teams/NAME  for `mirocup join --credentials`: a folder that only this team may get
#
# Existing files are kept. A folder appears only when it is complete. Folders are 0700, files 0600. There are two authorities because Cyclone DDS 0.10 accepts permissions that are signed by any
# identity that the permissions' authority has certified (CVE-2023-24011); so that authority certifies no identity.
set -euo pipefail
folder=$1
days=$2
shift 2
authority=$folder/authority
organisation=mirocup
longest_name=64   # bytes of a common name in a certificate (X.520)
umask 077
chmod 700 "$folder"
link=$(find "$folder" -type l -print -quit)
[[ -z $link ]] || { echo "mirocup: $link: it is a symbolic link, which is not followed here; remove it" >&2; exit 1; }

quietly() { # runs a command; its output is shown only if it fails
  local said
  said=$(timeout 60 "$@" 2>&1) || { echo "$said" >&2; return 1; }
}

new_key() {
  quietly openssl genpkey -algorithm EC -pkeyopt ec_paramgen_curve:prime256v1 -pkeyopt ec_param_enc:named_curve -out "$1"
}

# Certificates are valid from an earlier time, because the clocks of the league's computers may differ.
begin='-1 day'
end="+$days days"

certify() { # KEY SUBJECT INTO [OPTION...]
  quietly openssl req -new -key "$1" -subj "/O=$organisation/CN=$2" -out "$authority/request.pem"
  quietly openssl ca -batch -config "$authority/ca.cnf" -notext -in "$authority/request.pem" \
    -startdate "$(date -u -d "$begin" +%Y%m%d%H%M%SZ)" -enddate "$(date -u -d "$end" +%Y%m%d%H%M%SZ)" -out "$3" "${@:4}"
}

new_authority() {
  new_key "$authority/$1.key"
  certify "$authority/$1.key" "$1" "$authority/$1.pem" -selfsign -keyfile "$authority/$1.key" -extensions authority
}

sign() { # FILE.xml FILE.p7s
  quietly openssl smime -sign -in "$1" -text -out "$2" -signer "$authority/permissions_ca.pem" \
    -inkey "$authority/permissions_ca.key"
}

new_authorities() {
  mkdir -p "$authority/issued"
  : >"$authority/index.txt"
  echo 1000 >"$authority/serial"
  echo 1000 >"$authority/crlnumber"
  cat >"$authority/ca.cnf" <<CNF
[ca]
default_ca = league
[league]
database = $authority/index.txt
serial = $authority/serial
crlnumber = $authority/crlnumber
new_certs_dir = $authority/issued
certificate = $authority/identity_ca.pem
private_key = $authority/identity_ca.key
default_md = sha256
default_crl_days = $days
unique_subject = no
policy = any
[any]
organizationName = supplied
commonName = supplied
[authority]
basicConstraints = critical, CA:TRUE
subjectKeyIdentifier = hash
CNF
  new_authority identity_ca
  new_authority permissions_ca
  touch "$authority/complete"
}

new_governance() {
  governance >"$authority/governance.xml"
  sign "$authority/governance.xml" "$authority/governance.p7s"
}

# Every participant needs a certificate, and its rights to read and write are checked. Commands are encrypted; all other
# topics are signed, so that a reader cannot forge their messages.
governance() {
  topic() { # EXPRESSION PROTECTION
    cat <<XML
        <topic_rule>
          <topic_expression>$1</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>$2</metadata_protection_kind>
          <data_protection_kind>NONE</data_protection_kind>
        </topic_rule>
XML
  }
  cat <<XML
<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      <domains><id_range><min>0</min><max>230</max></id_range></domains>
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>SIGN</liveliness_protection_kind>
      <rtps_protection_kind>NONE</rtps_protection_kind>
      <topic_access_rules>
$(topic TeamCommand ENCRYPT)
$(topic '*' SIGN_WITH_ORIGIN_AUTHENTICATION)
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
XML
}

rule() { # publish|subscribe PARTITION TOPIC...
  local kind=$1 partition=$2 topic
  shift 2
  echo "<$kind><topics>"
  for topic in "$@"; do echo "<topic>$topic</topic>"; done
  echo "</topics><partitions><partition>$partition</partition></partitions></$kind>"
}

rules_of() { # KIND WORD; WORD is the team's name as in partitions
  case $1 in
    server)
      rule publish 'match-*' WorldState MatchEvent MatchInfo Welcome
      rule subscribe 'match-*' TeamCommand Hello ;;
    spectator)
      rule subscribe 'match-*' WorldState MatchEvent MatchInfo ;;
    team)
      rule publish "match-*/$2" TeamCommand Hello
      rule subscribe "match-*/$2" Welcome
      rule subscribe 'match-*' WorldState MatchEvent MatchInfo ;;
  esac
}

permissions() { # KIND WORD CERTIFICATE
  local from to
  from=$(date -u -d "$begin" +%Y-%m-%dT%H:%M:%S)
  to=$(date -u -d "$end" +%Y-%m-%dT%H:%M:%S)
  cat <<XML
<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
    xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name="$1">
      <subject_name>$(openssl x509 -in "$3" -noout -subject -nameopt RFC2253 | sed 's/^subject=//')</subject_name>
      <validity><not_before>$from</not_before><not_after>$to</not_after></validity>
      <allow_rule><domains><id_range><min>0</min><max>230</max></id_range></domains>
$(rules_of "$1" "$2")
      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
XML
}

encoded() { # encodes characters that are unsafe in a partition as %XX, as server/dds/domain.cpp does
  local LC_ALL=C text=$1 out= c i
  for ((i = 0; i < ${#text}; ++i)); do
    c=${text:i:1}
    case $c in
      [a-zA-Z0-9._-]) out+=$c ;;
      *) printf -v c '%%%02X' "'$c"; out+=${c/FFFFFFFFFFFFFF/} ;;
    esac
  done
  echo "$out"
}

common_name() { # KIND WORD; a name that is too long for a certificate is replaced by its digest
  local name="$1 $2" digest
  if [[ ${#name} -gt $longest_name ]]; then
    digest=$(printf '%s' "$2" | sha256sum)
    name="$1 sha256-${digest:0:40}"
  fi
  echo "$name"
}

issue() { # KIND NAME INTO
  local kind=$1 word into=$3 new
  word=$(encoded "$2")
  if [[ -e $into/permissions.p7s ]]; then return 0; fi
  new=$(mktemp -d "$folder/.new.XXXXXX")
  new_key "$new/key.pem"
  certify "$new/key.pem" "$(common_name "$kind" "$word")" "$new/certificate.pem"
  cp "$authority/identity_ca.pem" "$authority/permissions_ca.pem" "$authority/governance.p7s" "$new/"
  permissions "$kind" "$word" "$new/certificate.pem" >"$authority/permissions.xml"
  sign "$authority/permissions.xml" "$new/permissions.p7s"
  mkdir -p "$(dirname "$into")"
  rm -rf "$into"   # what an earlier call left unfinished
  mv -T "$new" "$into"
  echo "$into"
}

issue_to_team() { # NAME
  local word
  word=$(encoded "$1")
  issue team "$1" "$folder/teams/$word"
  mkdir -p "$folder/server/teams"
  cp "$folder/teams/$word/certificate.pem" "$folder/server/teams/$word.pem"
}

revoke() { # NAME
  local word
  word=$(encoded "$1")
  if [[ ! -e $folder/teams/$word/certificate.pem ]]; then
    echo "credentials: \"$1\" has no credentials to revoke" >&2
    return 1
  fi
  quietly openssl ca -config "$authority/ca.cnf" -revoke "$folder/teams/$word/certificate.pem"
  update_revoked
  rm -f "$folder/server/teams/$word.pem"
  rm -r "$folder/teams/$word"
}

update_revoked() {
  quietly openssl ca -config "$authority/ca.cnf" -gencrl -out "$folder/server/revoked.pem"
}

rm -rf "$folder"/.new.*   # of a call that was killed
[[ -e $authority/complete ]] || new_authorities
grep -qs "<max>230</max>" "$authority/governance.xml" || new_governance
issue server server "$folder/server"
issue spectator spectator "$folder/spectator"
failed=()
while [[ $# -gt 0 ]]; do
  [[ -n ${2:-} && $2 != . && $2 != .. ]] || { echo "credentials: \"${2:-}\" is no name of a team" >&2; exit 2; }
  case $1 in
    team) issue_to_team "$2" & ;;   # a process of its own ends by itself at its first error
    revoke) revoke "$2" & ;;
    *) exit 2 ;;
  esac
  wait $! || failed+=("$2")
  shift 2
done
update_revoked
if [[ ${#failed[@]} -gt 0 ]]; then
  echo "credentials: not done for: ${failed[*]}" >&2
  exit 1
fi
