package nephele.editor.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;

/** The sections of a level, found from its record class: lists of entities, and single records. */
public final class LevelStructure {
    /** The structure of levels of this version. */
    public static final LevelStructure LEVEL = of(Level.class);

    private final List<EntitySection> lists = new ArrayList<>();
    private final List<SingleSection> singles = new ArrayList<>();

    private LevelStructure(Class<? extends Record> root) {
        singles.add(new SingleSection("", List.of(), List.of(RecordKind.of(root))));
        explore(RecordKind.of(root), "", List.of());
    }

    /** Returns the structure of a root record. */
    public static LevelStructure of(Class<? extends Record> root) {
        return new LevelStructure(root);
    }

    private void explore(RecordKind owner, String prefix, List<RecordField> steps) {
        for (RecordField field : owner.fields()) {
            String path = prefix + field.name();
            List<RecordKind> kinds =
                    field.recordClasses().stream().map(RecordKind::of).toList();
            if (kinds.isEmpty() || field.valueClass() == EditorNotes.class) {
                continue;
            }
            if (field.kind() == FieldKind.LIST && kinds.stream().allMatch(LevelStructure::hasId)) {
                lists.add(new EntitySection(path, steps, field, kinds));
            } else if (field.kind() == FieldKind.RECORD || field.kind() == FieldKind.VARIANT) {
                List<RecordField> deeper = new ArrayList<>(steps);
                deeper.add(field);
                singles.add(new SingleSection(path, List.copyOf(deeper), kinds));
                if (kinds.size() == 1 && !field.isNullable()) {
                    explore(kinds.get(0), path + ".", List.copyOf(deeper));
                }
            }
        }
    }

    private static boolean hasId(RecordKind kind) {
        return kind.fields().stream().anyMatch(RecordField::isId);
    }

    /** Returns the lists of entities, in the order of the file. */
    public List<EntitySection> lists() {
        return List.copyOf(lists);
    }

    /** Returns the single records, the level itself first. */
    public List<SingleSection> singles() {
        return List.copyOf(singles);
    }

    public Optional<EntitySection> list(String path) {
        return lists.stream().filter(section -> section.path().equals(path)).findFirst();
    }

    public Optional<SingleSection> single(String path) {
        return singles.stream().filter(section -> section.path().equals(path)).findFirst();
    }
}
