package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.record.EntitySection;
import nephele.editor.record.LevelStructure;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.text.Words;

/** The entities that the palette offers: all kinds of all lists, and the single records that a level may be without. */
public final class PaletteModel {
    private PaletteModel() {}

    /**
     * A kind of entity.
     *
     * @param section path of its list or single record
     * @param kind its word in files
     */
    public record Entry(String section, String kind) {
        /** Returns the kind for users, and behind it the list where kinds of other lists have the same name. */
        public Words words() {
            Words kindWords = KindWords.of(kind);
            boolean isAmbiguous = entries(LevelStructure.LEVEL).stream()
                    .anyMatch(other -> other.kind.equals(kind) && !other.section.equals(section));
            Words list = sectionWords();
            return isAmbiguous ? Words.same("%s – %s").with(kindWords, list) : kindWords;
        }

        /** Returns the words of the list or of the single record. */
        public Words sectionWords() {
            String last = section.substring(section.lastIndexOf('.') + 1);
            return FieldWords.known(last).orElseGet(() -> Words.same(last));
        }
    }

    /** Returns the entries in the order of the file. */
    public static List<Entry> entries(LevelStructure structure) {
        List<Entry> entries = new ArrayList<>();
        for (SingleSection single : structure.singles()) {
            if (single.isOptional()) {
                add(entries, single.path(), single.kinds());
            }
        }
        for (EntitySection section : structure.lists()) {
            add(entries, section.path(), section.kinds());
        }
        return List.copyOf(entries);
    }

    private static void add(List<Entry> entries, String section, List<RecordKind> kinds) {
        kinds.forEach(kind -> entries.add(new Entry(section, kind.name())));
    }
}
