package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.stream.Stream;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Round trip of orders and answers through their lines. */
@Execution(ExecutionMode.CONCURRENT)
class PlayOrderTest {
    private static final PlayerStart FROM = new PlayerStart(new Vec3(1.5, -2.25, 1.0 / 3), 190, -20);

    @Test
    void anOrderIsALineThatSaysTheSame() {
        var order = new PlayOrder("/levels/a \"b\" ção {}.json", "C:\\temp\\x.json", FROM, "low", "/r/a.json");
        assertEquals(1, order.line().lines().count());
        assertEquals(order, PlayOrder.read(order.line()));
        var least = new PlayOrder("a.json", "b.json", null, null, null);
        assertEquals(least, PlayOrder.read(least.line()));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "play",
                "play ",
                "play {}",
                "stop",
                "play {\"format\": \"nephele-play-order\", \"version\": 1, \"level\": \"a\"}",
                "play {\"format\": \"nephele-play-order\", \"version\": 1, \"level\": \"a\", \"snapshot\": \"b\","
                        + " \"x\": 1}"
            })
    void whatIsNoOrderIsRejected(String line) {
        var wrong = assertThrows(LevelFormatException.class, () -> PlayOrder.read(line));
        assertTrue(wrong.getMessage().startsWith("order: "), wrong.getMessage());
    }

    @Test
    void aLineThatIsTooLongIsRejectedUnread() {
        var wrong = assertThrows(
                LevelFormatException.class, () -> PlayOrder.read("play " + "[".repeat(PlayOrder.MOST_CHARACTERS)));
        assertTrue(wrong.getMessage().contains("longer than"), wrong.getMessage());
    }

    static Stream<PlayAnswer> answers() {
        return Stream.of(
                new PlayAnswer.Ready(),
                new PlayAnswer.Playing(812),
                new PlayAnswer.Baking(40),
                new PlayAnswer.Ended(new PlayEnd(FROM, true, 12.25, 3, "/r/a.json")),
                new PlayAnswer.Ended(new PlayEnd(FROM, false, 0, 0, null)),
                new PlayAnswer.Failed("a.json: $: cannot be read"));
    }

    @ParameterizedTest
    @MethodSource("answers")
    void anAnswerIsALineThatSaysTheSame(PlayAnswer answer) {
        assertFalse(answer.line().contains("\n"));
        assertEquals(Optional.of(answer), PlayAnswer.read(answer.line()));
    }

    @Test
    void aMessageOfSeveralLinesBecomesOne() {
        assertEquals("failed one two", new PlayAnswer.Failed("one\n  two\n").line());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "playing", "playing soon", "ended {}", "libGL warning: dri2"})
    void otherLinesAreNoAnswers(String line) {
        assertEquals(Optional.empty(), PlayAnswer.read(line));
    }
}
