package nephele.engine.sim.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Range;
import nephele.engine.level.Spatial;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.RecordFile;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;

/**
 * A recorded input sequence of a level, tick by tick: with the level it repeats a game exactly.
 *
 * @param level the level's file name without folder, for people; the caller that reads a replay decides which level to
 *     load
 * @param levelName the level's {@code name}; {@code null} if not recorded
 * @param levelSha256 of the level's canonical text, as {@link LevelJson#sha256} gives it; {@code null} if not recorded
 * @param start where the player starts, {@code null} for the level's start
 * @param track where these inputs led the player in the level as recorded; empty if not recorded
 */
public record Replay(
        @Written(required = true) String level,
        @Written String levelName,
        @Written(text = TextKind.SHA256) String levelSha256,
        @Written(absent = "120")
                @Range(min = SimSettings.LEAST_TICKS_PER_SECOND, max = SimSettings.MOST_TICKS_PER_SECOND)
                int ticksPerSecond,
        @Written List<Assist> assists,
        @Written(absent = "360")
                @Range(
                        min = SimSettings.LEAST_UPRIGHT_DEGREES_PER_SECOND,
                        max = SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND)
                int uprightDegreesPerSecond,
        @Written PlayerStart start,
        @Written(required = true, most = 400_000) List<Run> inputs,
        @Written(most = 400_000) List<Waypoint> track) {
    private static final RecordFile<Replay> FILE = RecordFile.of("replay", 1, Replay.class);

    /** A run of equal inputs of successive ticks. Turns are per tick. */
    public record Run(
            @Written(required = true) @Range(min = 1) int ticks,
            @Written @Range(min = -100, max = 100) int forwardPercent,
            @Written @Range(min = -100, max = 100) int rightPercent,
            @Written @Range(min = -PlayerInput.MAX_TURN_MILLIDEGREES, max = PlayerInput.MAX_TURN_MILLIDEGREES)
                    int turnLeftMillidegrees,
            @Written @Range(min = -PlayerInput.MAX_TURN_MILLIDEGREES, max = PlayerInput.MAX_TURN_MILLIDEGREES)
                    int turnUpMillidegrees,
            @Written(most = 16) List<Action> hold) {
        static Run of(PlayerInput input, int ticks) {
            return new Run(
                    ticks,
                    input.forwardPercent(),
                    input.rightPercent(),
                    input.turnLeftMillidegrees(),
                    input.turnUpMillidegrees(),
                    Action.ALL.stream().filter(input::holds).toList());
        }

        public PlayerInput input() {
            int actions = 0;
            for (Action action : hold) {
                actions |= action.bit();
            }
            return new PlayerInput(forwardPercent, rightPercent, turnLeftMillidegrees, turnUpMillidegrees, actions);
        }
    }

    public Replay(String level, SimSettings settings, PlayerStart start, List<Run> inputs) {
        this(
                level,
                null,
                null,
                settings.ticksPerSecond(),
                settings.assists(),
                settings.uprightDegreesPerSecond(),
                start,
                inputs,
                List.of());
    }

    /** Returns this replay with the name and hash of the level that it was recorded in. */
    public Replay recordedIn(Level recorded) {
        String name = recorded.name().isEmpty() ? null : recorded.name();
        String sha256 = LevelJson.sha256(recorded);
        return new Replay(level, name, sha256, ticksPerSecond, assists, uprightDegreesPerSecond, start, inputs, track);
    }

    /**
     * Returns this replay with its track, so that after an edit of the level the first difference can be found.
     *
     * @param simulation of the level that it was recorded in, with the settings of this replay
     */
    public Replay tracked(Simulation simulation) {
        List<Waypoint> places = new ArrayList<>();
        play(simulation, state -> {
            if (Waypoint.isDue(state)) {
                places.add(Waypoint.of(state));
            }
        });
        return new Replay(
                level,
                levelName,
                levelSha256,
                ticksPerSecond,
                assists,
                uprightDegreesPerSecond,
                start,
                inputs,
                List.copyOf(places));
    }

    /** Returns a replay without input, of a player standing at the level's start. */
    public static Replay standing(String level, int ticks) {
        return new Replay(level, SimSettings.DEFAULT, null, List.of(Run.of(PlayerInput.NONE, ticks)));
    }

    /**
     * Reads a replay file.
     *
     * @param file the file's name in messages
     * @throws LevelFormatException with all problems found
     */
    public static Replay read(String file, byte[] utf8) {
        return FILE.read(file, utf8);
    }

    /** Returns the file's text. */
    public String write() {
        return FILE.write(this);
    }

    /** Returns the simulation settings that the replay was recorded with. */
    public SimSettings settings() {
        return new SimSettings(ticksPerSecond, assists, uprightDegreesPerSecond);
    }

    /** Returns the length in ticks. */
    public long ticks() {
        return inputs.stream().mapToLong(Run::ticks).sum();
    }

    /** Returns the state before the first input. */
    public SimState startIn(Simulation simulation) {
        return start == null ? simulation.start() : simulation.startFrom(start);
    }

    /** Plays all inputs from the start and returns the last state; the listener receives the state after each tick. */
    public SimState play(Simulation simulation, Consumer<SimState> listener) {
        SimState state = startIn(simulation);
        for (Run run : inputs) {
            PlayerInput input = run.input();
            for (int i = 0; i < run.ticks(); i++) {
                state = simulation.step(state, input);
                listener.accept(state);
            }
        }
        return state;
    }

    /**
     * Returns a listener of {@link #play} that gives the lines of {@code simulate}: {@code tick hash}, for every n-th
     * tick.
     *
     * @param last the last tick, which always has a line
     */
    public static Consumer<SimState> hashes(long every, long last, Consumer<String> lines) {
        return state -> {
            if (state.tick() % every == 0 || state.tick() == last) {
                lines.accept(hashLine(state));
            }
        };
    }

    /** Returns the line of a state; the hash has sixteen hexadecimal digits. */
    public static String hashLine(SimState state) {
        return String.format(Locale.ROOT, "%d %016x", state.tick(), state.hash());
    }

    /**
     * The player's place after a tick of a recording.
     *
     * @param tick the number of ticks since the start
     * @param opened the shots that placed a portal in this tick
     */
    public record Waypoint(
            @Written(required = true) @Range(min = 1, max = Integer.MAX_VALUE) int tick,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 feet,
            @Written(most = 2) List<GunPortals.Colour> opened) {
        /** Number of ticks between two places, a quarter of a second at the usual rate. */
        private static final int INTERVAL_TICKS = 30;

        /** Returns true for the states that a track lists: at regular intervals, and where a portal opened or the level ended. */
        static boolean isDue(SimState state) {
            return state.tick() % INTERVAL_TICKS == 0
                    || state.world().trace().events().stream()
                            .anyMatch(event ->
                                    event instanceof TickEvent.PortalOpened || event instanceof TickEvent.ExitReached);
        }

        static Waypoint of(SimState state) {
            return new Waypoint((int) state.tick(), state.player().feet(), opened(state));
        }

        /** Returns the shots that placed a portal in a state's last tick. */
        public static List<GunPortals.Colour> opened(SimState state) {
            return state.world().trace().events().stream()
                    .filter(TickEvent.PortalOpened.class::isInstance)
                    .map(event -> ((TickEvent.PortalOpened) event).shot())
                    .toList();
        }
    }
}
