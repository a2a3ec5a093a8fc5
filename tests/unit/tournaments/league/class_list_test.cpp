// SPDX-License-Identifier: MIT
#include "tournaments/league/class_list.hpp"

#include "system/text.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

// Returns what is read of a list, or why it is refused: "1 team, 2 members | a (A): Ann, Bo".
std::string read(const std::string& text, const std::string& columns = "") {
  const auto list = read_class_list(text, columns);
  if (!list) return list.error().what;
  std::string all = list->size_in_words();
  for (const ClassListRow& row : list->rows) {
    all += " | " + row.team + (row.people.display.empty() ? "" : " (" + row.people.display + ")");
    all += ": " + system::joined(row.people.members, ", ");
    for (const auto& [heading, value] : row.people.more) all += " / " + heading + "=" + value;
  }
  for (const std::string& student : list->without_team) all += " | none: " + student;
  return all;
}

// Each list has a line for each student, as systems of universities export it.
TEST(ClassList, JoinsTheStudentsOfATeam) {
  const std::string people =
      "2 teams, 3 members, 3 mails | Gruppe-1 (Gruppe 1): Ann Ey, Bo Groß / MAIL=ann@x; bo@x | "
      "Gruppe-2 (Gruppe 2): Cy Zoë / MAIL=cy@x";
  const std::pair<const char*, std::string> lists[]{
      {"Email address",
       "\xef\xbb\xbf\"First name\",\"Last name\",\"Email address\",Groups\r\n"
       "Ann,Ey,ann@x,\"Gruppe 1, Lab A\"\r\nBo,Groß,bo@x,\"Gruppe 1\"\r\n"
       "Cy,Zoë,cy@x,\"Lab B, Gruppe 2\"\r\n"},
      {"E-Mail-Adresse",
       "Nachname;Vorname;E-Mail-Adresse;Gruppe\nEy;Ann;ann@x;Gruppe 1\n"
       "Groß;Bo;bo@x;Gruppe 1\nZoë;Cy;cy@x;Gruppe 2\n"},
      {"E-MAIL",
       "sep=\t\nNAME\tVORNAME\tE-MAIL\tTEAM NAME\nEy\tAnn\tann@x\tGruppe 1\n"
       "Groß\tBo\tbo@x\tGruppe 1\nZoë\tCy\tcy@x\tGruppe 2\n"},
      {"eMail",
       "Name,Surname,eMail,Team\nAnn,Ey,ann@x,Gruppe 1\nBo,Groß,bo@x,Gruppe 1\n"
       "Cy,Zoë,cy@x,Gruppe 2\n"},
      {"Mail",
       "Vollst\xe4ndiger Name;Mail;Gruppen\rAnn Ey;ann@x;Gruppe 1\rBo Gro\xdf;bo@x;Gruppe 1"
       "\rCy Zo\xeb;cy@x;Gruppe 2"}};
  for (const auto& [mail, text] : lists)
    EXPECT_EQ(read(text), system::replaced(people, "MAIL", mail)) << text;
  EXPECT_EQ(
      read("Wer;Kontakt;Kurs\nAnn Ey;ann@x;Gruppe 1\nBo Groß;bo@x;Gruppe 1\nCy Zoë;cy@x;Gruppe 2",
           "team=Kurs,mail=kontakt,members=Wer"),
      system::replaced(people, "MAIL", "mail"));
}

// Catches a zero that is lost, and a value that goes to another student.
TEST(ClassList, KeepsWhatItDoesNotKnow) {
  EXPECT_EQ(
      read("team,number,Note,members\na,0042,x,Ann\nb,\"=\"\"007\"\"\",\"y; z\",Bo\na,,,Cy\n"),
      "2 teams, 3 members | a: Ann, Cy / number=0042;  / Note=x;  | b: Bo / number=007 / Note=y, "
      "z");
  EXPECT_EQ(
      read("Name;Gruppe\nAnn;Löwen & Co\nBo;-\nCy;Keine Gruppen\nDi;\n"),
      "1 team, 1 member | Lowen-Co (Löwen & Co): Ann | none: Bo (line 3) | none: Cy (line 4) | "
      "none: Di (line 5)");
  EXPECT_EQ(read("Name;Groups\nAnn;Lab A, Team 1\nBo;Lab A\n"),
            "1 team, 1 member | Team-1 (Team 1): Ann | none: Bo (line 3)");
  // A list by team stays as it is.
  EXPECT_EQ(read("team;display;members;Gruppe\na;A B;Ann; Bo;Lab\n").substr(0, 16),
            "line 2: it has m");
  EXPECT_EQ(read("team;display;members;Gruppe\na;A B;\"Ann; Bo\";Lab\n"),
            "1 team, 2 members | a (A B): Ann, Bo / Gruppe=Lab");
}

TEST(ClassList, SaysWhatWouldBeGivenToTheWrongStudent) {
  const std::pair<const char*, const char*> lists[]{
      {"team;members\na;Ann Ey, Bo Oz\n",
       "line 2: a: \"Ann Ey, Bo Oz\" has a comma: write \"Ann Ey; Bo"},
      {"Name;Gruppe\n\"Ey, Ann\";1\n",
       "line 2: Ey, Ann: \"Ey, Ann\" has a comma: write \"Ann Ey\""},
      {"team;mail\na;ann@x, bo@x\n", "line 2: a: \"ann@x, bo@x\" is no mail"},
      {"team;mail\na;ann @x\n", "line 2: a: \"ann @x\" is no mail"},
      {"team;members;mail\na;Ann;b@x\nb;\"C; D\";c@x\n", "line 3: b: 2 members, but 1 mail"},
      {"team;members;number\na;\"Ann; Bo\";1\n", "line 2: a: 2 members, but 1 number"},
      {"Name;Mail;Gruppe\nAnn;a@x;1\nBo;;1\n", "line 3: Bo: 1 member, but 0 mails"},
      {"Name;Mail;Gruppe\nAnn;a@x;1\nBo;A@x;2\n", "line 3: Bo is in line 2 as well"},
      {"Name;Gruppe\nA;Team 1\nB;Team-1\n",
       "line 3: Team-1 is in line 2 as well, as \"Team 1\": write that, or another"},
      {"Name;Gruppe\nA;Team 1\nB;team 1\n",
       "line 3: team-1 is in line 2 as well, as \"Team 1\": write that, or another"},
      {"Name;Gruppe\nA;Team 1, Team 2\n", "line 2: \"Team 1, Team 2\" are several groups"},
      {"Name;Gruppe\nA;Lab 1, Oz\n", "line 2: \"Lab 1, Oz\" are several groups"},
      {"Name;Kurs\nA;1\n",
       "line 1: the first line names the columns, as in team,display,members: there "
       "is no column \"team\"; --columns team=HEADING names another one: Name, Kurs"}};
  for (const auto& [text, why] : lists)
    EXPECT_EQ(read(text).substr(0, std::string(why).size()), why);
  for (const char* columns : {"team=Kurz", "tem=Kurs", "Kurs"})
    EXPECT_EQ(read("Name;Kurs\nA;1\n", columns)
                  .find("line 1: --columns " + std::string(columns) + ": KEY="),
              0u);
}

}  // namespace
}  // namespace mirocup::league
