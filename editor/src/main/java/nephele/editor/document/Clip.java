package nephele.editor.document;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.engine.level.EditorNotes.Group;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;

/**
 * Copied entities as JSON text: a level that has nothing but them and the materials that they use, so that it can be
 * read, mailed, and pasted into any level. Groups stay groups.
 */
public final class Clip {
    private static final String MATERIALS = "materials";

    private Clip() {}

    /** Returns the text of the entities of lists; single records cannot be copied. */
    public static String text(Level level, Collection<EntityRef> refs) {
        Set<EntityRef> wanted = new LinkedHashSet<>(refs);
        for (EntityRef ref : refs) {
            Entities.LEVEL.find(level, ref).ifPresent(entity -> wanted.addAll(materials(entity)));
        }
        Environment none = new Environment(null, null, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        Level clip = Level.of("", "", none, List.of());
        for (EntitySection section : Entities.LEVEL.lists()) {
            List<Record> chosen = section.entities(level).stream()
                    .filter(entity -> wanted.contains(new EntityRef(section.path(), RecordKind.id(entity))))
                    .toList();
            clip = section.with(clip, chosen);
        }
        return LevelJson.write(NoteEdits.copied(clip, level.editor(), refs));
    }

    private static List<EntityRef> materials(Record entity) {
        List<EntityRef> used = new ArrayList<>();
        RecordKind.mapped(entity, (field, value) -> {
            if (field.declaration().refersTo().equals(MATERIALS) && value != null) {
                used.add(new EntityRef(MATERIALS, (String) value));
            }
            return value;
        });
        return used;
    }

    /**
     * Adds the entities of a text and selects them; those whose id is taken get another one, and references among them
     * follow. A material that the level has already stays as it is.
     *
     * @param by displacement of what is pasted, metres
     * @throws LevelFormatException if the text is no level
     */
    public static Snapshot pasted(Snapshot before, String text, Vec3 by) throws LevelFormatException {
        Level clip = LevelJson.read("clipboard", text.getBytes(StandardCharsets.UTF_8));
        Level level = before.level();
        Map<String, Map<String, String>> newIds = freshIds(clip, level);
        List<EntityRef> pasted = new ArrayList<>();
        for (EntitySection section : Entities.LEVEL.lists()) {
            boolean isMaterials = section.path().equals(MATERIALS);
            Set<String> present = new HashSet<>();
            section.entities(level).forEach(entity -> present.add(RecordKind.id(entity)));
            List<Record> all = new ArrayList<>(section.entities(level));
            boolean onlyMaterials = isMaterials && hasOnlyMaterials(clip);
            for (Record entity : section.entities(clip)) {
                String id = RecordKind.id(entity);
                if (isMaterials && !onlyMaterials) {
                    if (!present.contains(id)) {
                        all.add(entity);
                    }
                    continue;
                }
                String newId = newIds.get(section.path()).get(id);
                all.add(EntityTransform.moved(referring(Entities.withId(entity, newId), newIds), by));
                pasted.add(new EntityRef(section.path(), newId));
            }
            if (all.size() > section.entities(level).size()) {
                level = section.with(level, all);
            }
        }
        for (Group group : clip.editor().groups()) {
            List<EntityRef> members = group.members().stream()
                    .map(EntityRef::of)
                    .map(ref -> new EntityRef(
                            ref.section(),
                            newIds.getOrDefault(ref.section(), Map.of()).getOrDefault(ref.id(), "")))
                    .filter(pasted::contains)
                    .toList();
            level = members.size() < 2 ? level : NoteEdits.grouped(level, NoteEdits.freshGroup(level), members);
        }
        return new Snapshot(level, Selection.of(pasted));
    }

    private static boolean hasOnlyMaterials(Level clip) {
        return Entities.LEVEL.lists().stream()
                .allMatch(section -> section.path().equals(MATERIALS)
                        || section.entities(clip).isEmpty());
    }

    private static Map<String, Map<String, String>> freshIds(Level clip, Level level) {
        Map<String, Map<String, String>> all = new HashMap<>();
        for (EntitySection section : Entities.LEVEL.lists()) {
            Map<String, String> ids = new HashMap<>();
            Set<String> taken = new HashSet<>();
            for (Record entity : section.entities(clip)) {
                String fresh = Entities.LEVEL.freshId(level, section.path(), RecordKind.id(entity), taken);
                taken.add(fresh);
                ids.put(RecordKind.id(entity), fresh);
            }
            all.put(section.path(), ids);
        }
        return all;
    }

    private static Record referring(Record entity, Map<String, Map<String, String>> newIds) {
        Record result = entity;
        for (Map.Entry<String, Map<String, String>> section : newIds.entrySet()) {
            if (!section.getKey().equals(MATERIALS)) {
                result = Entities.withReferences(
                        result, section.getKey(), id -> section.getValue().getOrDefault(id, id));
            }
        }
        return result;
    }
}
