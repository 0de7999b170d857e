package nephele.editor.panel.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.editor.record.Entities;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.text.EntityWords;
import nephele.editor.text.Words;

/**
 * A kind of entity that the palette offers: each kind of each list, and each single record that a level may be without.
 *
 * @param section path of its list or single record
 * @param kind its word in files
 */
public record PaletteEntry(String section, String kind) {
    /** Returns the name that a button shows. */
    public Words words() {
        return EntityWords.ofKind(section, kind);
    }

    /** Returns the heading above the button. */
    public EntityWords.Group group() {
        return EntityWords.group(section, kind);
    }

    /** Returns the words of the list or of the single record. */
    public Words sectionWords() {
        return EntityWords.ofSection(section);
    }

    /** Returns the entries in the order of the file. */
    public static List<PaletteEntry> all(Entities entities) {
        List<PaletteEntry> entries = new ArrayList<>();
        for (SingleSection single : entities.singles()) {
            if (single.isOptional()) {
                add(entries, single.path(), single.kinds());
            }
        }
        for (EntitySection section : entities.lists()) {
            add(entries, section.path(), section.kinds());
        }
        return List.copyOf(entries);
    }

    /** Returns the entries below a heading, in the order in which they are named. */
    public static List<PaletteEntry> below(Entities entities, EntityWords.Group group) {
        return all(entities).stream()
                .filter(entry -> entry.group() == group)
                .sorted(Comparator.comparing(entry -> EntityWords.rank(entry.section(), entry.kind())))
                .toList();
    }

    private static void add(List<PaletteEntry> entries, String section, List<RecordKind> kinds) {
        kinds.forEach(kind -> entries.add(new PaletteEntry(section, kind.name())));
    }
}
