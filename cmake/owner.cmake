# Who publishes mirocup, for the packages, SECURITY.md and CITATION.cff. Fill in all three before a release; `./check --all` fails until then.
set(MIROCUP_MAINTAINER "mirocup maintainers <mirocup@localhost>")  # a name, and an address that somebody reads
set(MIROCUP_HOMEPAGE "")                                           # https://…
set(MIROCUP_SECURITY_CONTACT "")                                   # an address or a page for reports that are not public
