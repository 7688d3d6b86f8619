<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>RuleDisplay</name>
    <message>
        <source>The word ‘%1’ is missing here.</source>
        <translation>Hier fehlt das Wort „%1“.</translation>
    </message>
    <message>
        <source>The word ‘%1’ is expected before ‘%2’.</source>
        <translation>Vor „%2“ wird das Wort „%1“ erwartet.</translation>
    </message>
    <message>
        <source>A rule begins with ‘%1’.</source>
        <translation>Eine Regel beginnt mit „%1“.</translation>
    </message>
    <message>
        <source>The name of a variable is missing here.</source>
        <translation>Hier fehlt der Name einer Größe.</translation>
    </message>
    <message>
        <source>‘%1’ stands where the name of a variable is expected.</source>
        <translation>Statt „%1“ wird hier der Name einer Größe erwartet.</translation>
    </message>
    <message>
        <source>A word that describes the variable is missing here.</source>
        <translation>Hier fehlt ein Wort, das die Größe beschreibt.</translation>
    </message>
    <message>
        <source>‘%1’ stands where a word for the variable is expected.</source>
        <translation>Statt „%1“ wird hier ein Wort für die Größe erwartet.</translation>
    </message>
    <message>
        <source>There is no variable named ‘%1’.</source>
        <translation>Eine Größe „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>‘%1’ is not a word of this variable.</source>
        <translation>„%1“ ist kein Wort dieser Größe.</translation>
    </message>
    <message>
        <source>‘%1’ is a result and cannot stand in the condition.</source>
        <translation>„%1“ ist ein Ergebnis und kann nicht in der Bedingung stehen.</translation>
    </message>
    <message>
        <source>‘%1’ is an input and cannot stand in the conclusion.</source>
        <translation>„%1“ ist eine Eingabe und kann nicht in der Folgerung stehen.</translation>
    </message>
    <message>
        <source>A weight between 0 and 1 is expected here.</source>
        <translation>Hier wird ein Gewicht zwischen 0 und 1 erwartet.</translation>
    </message>
    <message>
        <source>A parenthesis lacks its partner.</source>
        <translation>Einer Klammer fehlt ihr Gegenstück.</translation>
    </message>
    <message>
        <source>‘%1’ does not belong here.</source>
        <translation>„%1“ gehört nicht hierher.</translation>
    </message>
    <message>
        <source>The text is empty.</source>
        <translation>Der Text ist leer.</translation>
    </message>
</context>
<context>
    <name>esm::InputRow</name>
    <message>
        <source>%1 Is ‘%2’ meant?</source>
        <translation>%1 Ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>The value must lie between %1 and %2.</source>
        <translation>Der Wert muss zwischen %1 und %2 liegen.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieberegler</translation>
    </message>
    <message>
        <source>%1, number</source>
        <translation>%1, Zahl</translation>
    </message>
    <message>
        <source>%1, word</source>
        <translation>%1, Wort</translation>
    </message>
    <message>
        <source>Type a number or a word, for instance ‘%1’.</source>
        <translation>Eine Zahl oder ein Wort eingeben, zum Beispiel „%1“.</translation>
    </message>
    <message>
        <source>Reset %1 to its default</source>
        <translation>%1 auf die Voreinstellung zurücksetzen</translation>
    </message>
</context>
<context>
    <name>esm::InputsPanel</name>
    <message>
        <source>Tissue: %1</source>
        <translation>Gewebe: %1</translation>
    </message>
    <message>
        <source>No rule fires: this is the default.</source>
        <translation>Keine Regel feuert: Das ist die Voreinstellung.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>esm::MembershipPanel</name>
    <message>
        <source>Input: %1</source>
        <translation>Eingabe: %1</translation>
    </message>
    <message>
        <source>Result: %1</source>
        <translation>Ergebnis: %1</translation>
    </message>
    <message>
        <source>Variable that the plot shows</source>
        <translation>Größe, die das Diagramm zeigt</translation>
    </message>
</context>
<context>
    <name>esm::MembershipPlot</name>
    <message>
        <source>Plot of a variable&apos;s words</source>
        <translation>Diagramm der Wörter einer Größe</translation>
    </message>
    <message>
        <source>Plot of the words for %1</source>
        <translation>Diagramm der Wörter für %1</translation>
    </message>
    <message>
        <source>The words are: %1.</source>
        <translation>Die Wörter sind: %1.</translation>
    </message>
</context>
<context>
    <name>esm::MistakeBar</name>
    <message>
        <source>&amp;Replace by ‘%1’</source>
        <translation>Durch „%1“ &amp;ersetzen</translation>
    </message>
    <message>
        <source>Replace the marked word by ‘%1’</source>
        <translation>Das markierte Wort durch „%1“ ersetzen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Discard the text that is no rule</source>
        <translation>Den Text verwerfen, der keine Regel ist</translation>
    </message>
</context>
<context>
    <name>esm::RuleTableModel</name>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Rule %1 is on.</source>
        <translation>Regel %1 ist an.</translation>
    </message>
    <message>
        <source>Rule %1 is off.</source>
        <translation>Regel %1 ist aus.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Feuert</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>How strongly the rule fires for the current inputs, from 0 to 1.</source>
        <translation>Wie stark die Regel bei den jetzigen Eingaben feuert, von 0 bis 1.</translation>
    </message>
    <message>
        <source>How much the rule counts, from 0 to 1.</source>
        <translation>Wie viel die Regel zählt, von 0 bis 1.</translation>
    </message>
    <message>
        <source>Change the weight of rule %1</source>
        <translation>Gewicht von Regel %1 ändern</translation>
    </message>
    <message>
        <source>Change the note of rule %1</source>
        <translation>Notiz von Regel %1 ändern</translation>
    </message>
    <message>
        <source>Change rule %1</source>
        <translation>Regel %1 ändern</translation>
    </message>
    <message>
        <source>Add a rule</source>
        <translation>Regel hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate a rule</source>
        <translation>Regel verdoppeln</translation>
    </message>
    <message>
        <source>Duplicate %1 rules</source>
        <translation>%1 Regeln verdoppeln</translation>
    </message>
    <message>
        <source>Delete a rule</source>
        <translation>Regel löschen</translation>
    </message>
    <message>
        <source>Delete %1 rules</source>
        <translation>%1 Regeln löschen</translation>
    </message>
    <message>
        <source>Move a rule</source>
        <translation>Regel verschieben</translation>
    </message>
    <message>
        <source>Move %1 rules</source>
        <translation>%1 Regeln verschieben</translation>
    </message>
    <message>
        <source>Switch a rule on</source>
        <translation>Regel einschalten</translation>
    </message>
    <message>
        <source>Switch %1 rules on</source>
        <translation>%1 Regeln einschalten</translation>
    </message>
    <message>
        <source>Switch a rule off</source>
        <translation>Regel ausschalten</translation>
    </message>
    <message>
        <source>Switch %1 rules off</source>
        <translation>%1 Regeln ausschalten</translation>
    </message>
</context>
<context>
    <name>esm::RuleTextPage</name>
    <message>
        <source>Line %1: %2 The rules stay as they were until this is mended.</source>
        <translation>Zeile %1: %2 Bis das behoben ist, gelten die Regeln wie zuvor.</translation>
    </message>
    <message>
        <source>The rules cannot be used: %1.</source>
        <translation>Die Regeln sind nicht verwendbar: %1.</translation>
    </message>
    <message>
        <source>Edit the rules as text</source>
        <translation>Regeln als Text bearbeiten</translation>
    </message>
    <message>
        <source>Rules as text, one per line</source>
        <translation>Regeln als Text, eine je Zeile</translation>
    </message>
    <message>
        <source>Write one rule per line. Ctrl+Space proposes words.</source>
        <translation>Eine Regel je Zeile schreiben. Strg+Leertaste schlägt Wörter vor.</translation>
    </message>
</context>
<context>
    <name>esm::RulesPanel</name>
    <message>
        <source>Rule %1: %2 The rule stays as it was until this is mended.</source>
        <translation>Regel %1: %2 Bis das behoben ist, gilt die Regel wie zuvor.</translation>
    </message>
    <message>
        <source>No rule fired for %1 (%2); it takes its default %3.</source>
        <translation>Keine Regel feuerte für %1 (%2); es gilt die Voreinstellung %3.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a rule that says what holds now</source>
        <translation>Eine Regel hinzufügen, die beschreibt, was jetzt gilt</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Duplicate the selected rules</source>
        <translation>Die ausgewählten Regeln verdoppeln</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected rules</source>
        <translation>Die ausgewählten Regeln löschen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move the selected rules up</source>
        <translation>Die ausgewählten Regeln nach oben verschieben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move the selected rules down</source>
        <translation>Die ausgewählten Regeln nach unten verschieben</translation>
    </message>
    <message>
        <source>On/off</source>
        <translation>An/aus</translation>
    </message>
    <message>
        <source>Switch the selected rules on or off</source>
        <translation>Die ausgewählten Regeln ein- oder ausschalten</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Text (with mistakes)</source>
        <translation>Text (mit Fehlern)</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Ways to show the rules</source>
        <translation>Ansichten der Regeln</translation>
    </message>
    <message>
        <source>Rules as table</source>
        <translation>Regeln als Tabelle</translation>
    </message>
    <message>
        <source>Gaps in the rules</source>
        <translation>Lücken in den Regeln</translation>
    </message>
</context>
<context>
    <name>esm::WhyPanel</name>
    <message>
        <source>%1 is %2, the default, because no rule fired for it.</source>
        <translation>%1 ist %2, die Voreinstellung, weil keine Regel dafür feuerte.</translation>
    </message>
    <message>
        <source>%1 is %2, mainly because of rule %3: %4 (%5).</source>
        <translation>%1 ist %2, vor allem wegen Regel %3: %4 (%5).</translation>
    </message>
    <message>
        <source>One further rule did not fire.</source>
        <translation>Eine weitere Regel feuerte nicht.</translation>
    </message>
    <message>
        <source>%1 further rules did not fire.</source>
        <translation>%1 weitere Regeln feuerten nicht.</translation>
    </message>
    <message>
        <source>Tissue: %1</source>
        <translation>Gewebe: %1</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Feuert</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Rules that fired, the strongest first</source>
        <translation>Regeln, die feuerten, die stärkste zuerst</translation>
    </message>
</context>
</TS>
