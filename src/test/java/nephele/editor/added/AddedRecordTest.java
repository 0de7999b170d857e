package nephele.editor.added;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import nephele.editor.action.ScriptedSession;
import nephele.editor.record.Entities;
import nephele.editor.record.EntitySection;
import nephele.editor.record.SingleSection;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Execution(ExecutionMode.CONCURRENT)
class AddedRecordTest {
    private static final Vec3 AT = new Vec3(1, 2, 3);

    static Stream<String> everyKind() {
        Entities entities = Entities.LEVEL;
        Stream<String> lists = entities.lists().stream()
                .flatMap(section -> section.kinds().stream().map(kind -> section.path() + "." + kind.name()));
        return Stream.concat(
                lists,
                entities.singles().stream()
                        .filter(SingleSection::isOptional)
                        .flatMap(section -> section.kinds().stream().map(kind -> section.path() + "." + kind.name())));
    }

    @Test
    void theSectionsOfALevelAreFound() {
        assertEquals(
                List.of(
                        "environment.clouds",
                        "cameras",
                        "materials",
                        "solids",
                        "lights",
                        "portals",
                        "models",
                        "bodies",
                        "exits",
                        "emitters",
                        "terrains",
                        "billboards",
                        "hints"),
                Entities.LEVEL.lists().stream().map(EntitySection::path).toList());
        assertEquals(
                List.of(
                        "",
                        "environment",
                        "environment.sun",
                        "environment.sky",
                        "environment.fog",
                        "environment.lightning",
                        "player",
                        "portalGun",
                        "observer",
                        "par",
                        "landmark"),
                Entities.LEVEL.singles().stream().map(SingleSection::path).toList());
    }

    @ParameterizedTest
    @MethodSource("everyKind")
    void aNewEntityOfEveryKindIsWrittenAndReadBackEqual(String kind) {
        ScriptedSession session = ScriptedSession.empty().run("add kind=" + kind + " at=1,2,3");
        Level level = session.level();
        assertEquals(level, LevelJson.read(kind, LevelJson.write(level).getBytes(StandardCharsets.UTF_8)));
        assertTrue(session.session().document().history().canUndo());
    }

    @Test
    void aNewEntityIsWhereItWasMade() {
        Level level = ScriptedSession.empty()
                .run("add lights.spot at=1,2,3", "add cameras at=1,2,3")
                .level();
        assertEquals(AT, level.lights().get(0).position());
        assertEquals(AT, level.cameras().get(0).position());
        assertEquals(new Vec3(1, 2, 2), level.cameras().get(0).target());
    }
}
