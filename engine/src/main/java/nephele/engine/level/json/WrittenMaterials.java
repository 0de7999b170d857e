package nephele.engine.level.json;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The materials that a level's text refers to, for a text that cannot become a level; so an author can correct its
 * structure and its references together. {@link nephele.engine.rule.IdRules#MATERIALS} checks levels that can be
 * read.
 */
public final class WrittenMaterials {
    private static final List<String> SECTIONS = List.of("solids", "models", "bodies");

    private final JsonValue.Members level;
    private final Problems problems;
    private final Set<String> known = new HashSet<>();

    WrittenMaterials(JsonValue.Members level, Problems problems) {
        this.level = level;
        this.problems = problems;
    }

    /** Returns the message about a reference to a material that the level does not have. */
    public static String noMaterial(String id) {
        return "there is no material '" + id + "': add it to materials";
    }

    void reportUnknown() {
        JsonValue materials = level.ask("materials");
        if (materials != null && !(materials instanceof JsonValue.Array)) {
            return;
        }
        for (JsonValue material : entries(materials)) {
            if (material instanceof JsonValue.Members members && members.ask("id") instanceof JsonValue.Text id) {
                known.add(id.value());
            }
        }
        for (String section : SECTIONS) {
            int mark = problems.enter(section);
            reportEntries(level.ask(section));
            problems.leave(mark);
        }
    }

    private static List<JsonValue> entries(JsonValue json) {
        return json instanceof JsonValue.Array array ? array.values() : List.of();
    }

    private void reportEntries(JsonValue json) {
        List<JsonValue> entries = entries(json);
        for (int i = 0; i < entries.size(); i++) {
            int mark = problems.enter(i);
            if (entries.get(i) instanceof JsonValue.Members record) {
                report(record);
                reportFaces(record);
            }
            problems.leave(mark);
        }
    }

    private void report(JsonValue.Members record) {
        if (record.ask("material") instanceof JsonValue.Text material && !known.contains(material.value())) {
            int mark = problems.enter("material");
            problems.error(noMaterial(JsonTree.shortened(material.value())));
            problems.leave(mark);
        }
    }

    private void reportFaces(JsonValue.Members solid) {
        if (solid.ask("faces") instanceof JsonValue.Members faces) {
            int mark = problems.enter("faces");
            for (int i = 0; i < faces.size(); i++) {
                int face = problems.enter(faces.name(i));
                if (faces.value(i) instanceof JsonValue.Members record) {
                    report(record);
                }
                problems.leave(face);
            }
            problems.leave(mark);
        }
        int mark = problems.enter("planes");
        List<JsonValue> planes = entries(solid.ask("planes"));
        for (int i = 0; i < planes.size(); i++) {
            int plane = problems.enter(i);
            if (planes.get(i) instanceof JsonValue.Members record) {
                report(record);
            }
            problems.leave(plane);
        }
        problems.leave(mark);
    }
}
