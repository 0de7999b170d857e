package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import nephele.editor.text.EditorRefusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A number that an action does not take changes nothing: the message names the parameter and its range. */
@Execution(ExecutionMode.CONCURRENT)
class ScriptNumbersTest {
    private static final List<String> NEVER = List.of("NaN", "Infinity", "-1e300", "1e300", "1e8", "0x", "");

    /** The parameters that are no numbers. */
    private static final Set<String> WORDS = Set.of(
            "file face id kind value to ids shape material effect layer terrain show a b out scene replace".split(" "));

    private static ScriptedSession room() {
        return ScriptedSession.empty().run("brush box min=0,0,0 max=1,1,1 id=box", "select solids/box");
    }

    /** {@code #} is the number. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "paste by=0,#,0",
                "duplicate by=#,0,0",
                "add lights.point at=0,0,#",
                "drop nothing.png at=#,0,0",
                "move by=#,0,0",
                "turn axis=0,#,0",
                "turn degrees=#",
                "turn pivot=0,0,#",
                "scale by=1,#,1",
                "scale by=2,2,2 pivot=0,#,0",
                "brush box min=#,0,0 max=1,1,1",
                "brush box min=0,0,0 max=1,#,1",
                "brush room min=0,0,0 max=9,9,9 wall=#",
                "brush stairs min=0,0,0 max=9,9,9 steps=#",
                "hollow wall=#",
                "texture-fit across=#",
                "texture-fit down=#",
                "camera at=0,#,0",
                "camera at=0,0,0 yaw=#",
                "camera at=0,0,0 pitch=#",
                "grid metres=#",
                "path-trace show=false spp=#"
            })
    void aNumberOutOfItsRangeIsRefusedWithIt(String line) {
        ScriptedSession session = room();
        if (line.startsWith("paste")) {
            session.run("copy");
        }
        String parameter = line.substring(0, line.indexOf('#')).replaceAll(".* ([a-z]+)=[^=]*", "$1");
        String before = session.json();
        for (String value : NEVER) {
            String hostile = line.replace("#", value);
            EditorRefusal told =
                    assertThrows(EditorRefusal.class, () -> session.script().run(hostile), hostile);
            assertTrue(
                    told.getMessage().matches(parameter + " must be a (whole )?number from \\S+ to \\S+, not '.*'"),
                    hostile + ": " + told.getMessage());
            assertEquals(before, session.json(), hostile);
        }
    }

    /** A new parameter is a word, or stands among the lines above. */
    @Test
    void everyParameterIsAWordOrTriedAbove() throws NoSuchMethodException {
        String tried = String.join(
                " ",
                ScriptNumbersTest.class
                        .getDeclaredMethod("aNumberOutOfItsRangeIsRefusedWithIt", String.class)
                        .getAnnotation(ValueSource.class)
                        .strings());
        Set<String> known = Pattern.compile("([a-z]+)=[^ ]*#")
                .matcher(tried)
                .results()
                .map(found -> found.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
        known.addAll(WORDS);
        known.addAll(
                Set.of("from", "radius", "strength", "wipe", "restore", "open")); // need a terrain, a cloud, a file
        for (EditorAction action : Actions.ALL) {
            action.parameters().forEach(name -> assertTrue(known.contains(name), action.id() + " " + name));
        }
    }
}
