package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.action.ScriptedSession;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordKind;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Everything that can be added to a level or to a record makes a level without new errors. */
@Execution(ExecutionMode.CONCURRENT)
class AddedPartsTest {
    private static final AssetSource ASSETS = LevelAssets.beside(Path.of("levels", "untitled.json"));
    private static final InspectorModel MODEL = new InspectorModel(Entities.LEVEL);

    private static List<String> errors(Level level) {
        return ProblemSearch.of(level, ASSETS).stream()
                .filter(problem -> problem.severity() == LevelProblem.Severity.ERROR)
                .map(problem -> problem.path() + ": " + problem.message())
                .toList();
    }

    @ParameterizedTest
    @MethodSource("nephele.editor.added.AddedRecordTest#everyKind")
    void aNewEntityMakesNoErrorsAndNeitherDoItsParts(String kind) {
        ScriptedSession session = ScriptedSession.empty().run("brush box min=-9,-1,-9 max=9,0,9");
        if (kind.startsWith("portals.")) {
            // A portal alone cannot be valid: a script has to link two.
            session.run("add portals at=4,1,0 id=a", "set linkedTo to=b");
        }
        session.run("add kind=" + kind + " at=0,1,0" + (kind.startsWith("portals.") ? " id=b" : ""));
        if (kind.startsWith("portals.")) {
            session.run("set linkedTo to=a");
        }
        Level level = session.level();
        EntityRef ref = session.session().document().selection().entities().get(0);
        List<String> found = new ArrayList<>();
        errors(level).forEach(error -> found.add("add: " + error));
        for (InspectorField field : MODEL.fields(level, List.of(ref))) {
            parts(level, ref, field, 3, found);
        }
        assertEquals(List.of(), found);
    }

    /** Adds what the inspector offers at a field, and at the fields that this brings. */
    private static void parts(Level level, EntityRef ref, InspectorField field, int depth, List<String> found) {
        List<Level> changed = new ArrayList<>();
        List<EntityRef> refs = List.of(ref);
        if (field.type().kind() == FieldKind.LIST) {
            changed.add((Level) MODEL.added(level, refs, field, null));
        } else if (field.type().kind() == FieldKind.TABLE) {
            MODEL.missingKeys(level, refs, field)
                    .forEach(key -> changed.add((Level) MODEL.added(level, refs, field, key)));
        } else if (field.isHeading()) {
            field.type()
                    .field()
                    .recordClasses()
                    .forEach(type -> changed.add((Level) MODEL.withKind(level, refs, field, RecordKind.of(type))));
        } else if (field.isUnset()) {
            changed.add((Level) MODEL.fresh(level, refs, field));
        }
        for (Level after : changed) {
            boolean isRefused = MODEL.fields(after, refs).stream()
                    .filter(made -> made.path().equals(field.path()))
                    .anyMatch(made -> made.values().stream()
                            .anyMatch(value -> made.type().problem(value).isPresent()));
            for (String error : isRefused ? List.<String>of() : errors(after)) {
                found.add(field.path() + ": " + error);
            }
            if (depth > 0 && !after.equals(level)) {
                for (InspectorField next : MODEL.fields(after, refs)) {
                    boolean isNew = MODEL.fields(level, refs).stream()
                            .noneMatch(old -> old.path().equals(next.path()));
                    if (isNew) {
                        parts(after, ref, next, depth - 1, found);
                    }
                }
            }
        }
    }
}
