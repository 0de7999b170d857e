package nephele.engine.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.math.Vec3;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.ViewAngles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReplayTest {
    private static Replay read(String json) {
        return Replay.read("walk.json", json.getBytes(StandardCharsets.UTF_8));
    }

    private static PlayerInput random(SplittableRandom random) {
        return new PlayerInput(
                random.nextInt(3) * 100 - 100, 0, random.nextInt(2) * 25, -random.nextInt(2), random.nextInt(8));
    }

    @Test
    void readsBackWhatItWrites() {
        var random = new SplittableRandom(3);
        var settings = new SimSettings(240, List.of(Assist.FLOOR_EXIT_SPEED));
        var recorder = new ReplayRecorder("room.json", settings, new PlayerStart(new Vec3(1, 2, -3), 90, 0));
        List<PlayerInput> done = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            done.add(random(random));
            recorder.record(done.get(i));
        }
        Replay replay = read(recorder.replay().write());
        assertEquals(recorder.replay(), replay);
        List<PlayerInput> repeated = new ArrayList<>();
        replay.inputs().forEach(run -> {
            for (int i = 0; i < run.ticks(); i++) {
                repeated.add(run.input());
            }
        });
        assertEquals(done, repeated);
        assertEquals(500, replay.ticks());
    }

    @Test
    void equalTicksBecomeOneRun() {
        var recorder = new ReplayRecorder("room.json", SimSettings.DEFAULT, null);
        recorder.record(PlayerInput.FORWARD).record(PlayerInput.FORWARD).hold(PlayerInput.FORWARD, 1);
        assertEquals(1, recorder.replay().inputs().size());
        assertEquals(122, recorder.replay().ticks());
    }

    @Test
    void anAuthoredTurnEndsWhereItShould() {
        var recorder = new ReplayRecorder("room.json", SimSettings.DEFAULT, null);
        Replay replay = recorder.turn(PlayerInput.FORWARD, 100.0, -7, 0.7).replay();
        SimState end = replay.play(Course.onFloor().simulation(), state -> {});
        assertEquals(new ViewAngles(100_000, -7_000), end.player().heading());
    }

    @Test
    void playingTellsEveryTick() {
        List<String> lines = new ArrayList<>();
        Replay replay = Replay.standing("room.json", 25);
        SimState end = replay.play(Course.onFloor().simulation(), Replay.hashes(10, replay.ticks(), lines::add));
        assertEquals(3, lines.size());
        assertTrue(lines.get(0).matches("10 [0-9a-f]{16}"), lines.get(0));
        assertEquals(Replay.hashLine(end), lines.get(2));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            {"format":"nephele-replay","version":2,"level":"a","inputs":[]} | version:
            {"format":"nephele-level","version":1,"level":"a","inputs":[]} | format:
            {"format":"nephele-replay","version":1,"inputs":[]} | level: is missing
            {"format":"nephele-replay","version":1,"level":"a"} | inputs: is missing
            {"format":"nephele-replay","version":1,"level":"a","inputs":[{"ticks":0}]} | inputs[0].ticks:
            {"format":"nephele-replay","version":1,"level":"a","inputs":[{"ticks":1.5}]} | inputs[0].ticks:
            {"format":"nephele-replay","version":1,"level":"a","inputs":[{"ticks":1,"forwardPercent":101}]} | forwardPercent:
            {"format":"nephele-replay","version":1,"level":"a","inputs":[{"ticks":1,"hold":["fly"]}]} | inputs[0].hold[0]:
            {"format":"nephele-replay","version":1,"level":"a","inputs":[{"ticks":1,"up":1}]} | inputs[0].up: unknown key
            {"format":"nephele-replay","version":1,"level":"a","ticksPerSecond":0,"inputs":[]} | ticksPerSecond:
            {"format":"nephele-replay","version":1,"level":"a","inputs":[ | inputs: the file ends too early
            """)
    void aBrokenFileSaysWhere(String json, String message) {
        var error = assertThrows(LevelFormatException.class, () -> read(json));
        assertTrue(error.getMessage().contains(message), error.getMessage());
        assertTrue(error.getMessage().startsWith("walk.json: "), error.getMessage());
    }
}
