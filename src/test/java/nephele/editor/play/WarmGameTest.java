package nephele.editor.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Life cycle of the game's process, tested with shell scripts in place of the game. */
@Execution(ExecutionMode.CONCURRENT)
class WarmGameTest {
    private final GameNotes notes = new GameNotes();
    private WarmGame game;

    private WarmGame game(String... words) {
        game = new WarmGame(() -> List.of(words), notes);
        return game;
    }

    @AfterEach
    void end() {
        game.close();
    }

    private void expect(String line) throws InterruptedException {
        assertEquals(line, notes.next());
    }

    private static WarmGame.Request request() {
        String text = "{\"format\": \"nephele-level\", \"version\": 1}";
        var level = LevelJson.read("a", text.getBytes(StandardCharsets.UTF_8));
        return new WarmGame.Request(level, Path.of("a.json"), null, null, null);
    }

    @Test
    void aPlayWithoutAWaitingProcessStartsOne() throws Exception {
        game("sh", "-c", "read order; echo ready; echo playing 7; echo baking 30; cat; echo failed over")
                .play(request());
        expect("ready");
        expect("playing");
        expect("baking 30");
        game.close();
        expect("failed: over");
    }

    @Test
    void aProcessThatDiesIsReportedWithItsLastWordsAndReplaced() throws Exception {
        game("sh", "-c", "echo ready; read order; echo out of luck >&2; exit 7").warm();
        expect("ready");
        long first = game.processId().orElseThrow();
        game.play(request());
        expect("failed: the game ended (exit code 7): out of luck");
        expect("ready");
        assertNotEquals(first, game.processId().orElseThrow());
    }

    @Test
    void aProcessThatNeverBecomesReadyIsNotStartedForEver() throws Exception {
        game("sh", "-c", "echo no display >&2; exit 3").warm();
        expect("failed: the game ended (exit code 3): no display");
        assertEquals(List.of(), notes.rest());
        assertFalse(game.isReady());
    }

    @Test
    void aMissingProgramIsReported() {
        game("/nonexistent/java").play(request());
        assertEquals(1, notes.rest().size());
        assertEquals(0, notes.rest().get(0).toString().indexOf("failed: the game can't be started: "));
    }

    @Test
    void afterItsEndNothingIsPlayed() {
        game("sh", "-c", "echo ready; cat").close();
        game.play(request());
        assertEquals(List.of(), notes.rest());
        assertEquals(false, game.processId().isPresent());
    }
}
