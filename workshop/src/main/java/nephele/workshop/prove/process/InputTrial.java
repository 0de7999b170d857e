package nephele.workshop.prove.process;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.LevelAssets;
import nephele.engine.choice.CloudExplanation;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.FramePlan;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.rule.LevelRules;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.host.draw.QualityChoice;
import nephele.host.named.Viewpoints;

/**
 * Uses odd levels: each is refused with the place of what is wrong, or it is saved and read back equal, explained,
 * simulated and drawn.
 */
final class InputTrial {
    /** What became of a level. */
    enum Outcome {
        REFUSED,
        ACCEPTED,
        DRAWN
    }

    /** A broken promise of the program. */
    private static final class Fault extends Exception {
        private static final long serialVersionUID = 1;

        Fault(String message) {
            super(message);
        }
    }

    private static final int WIDTH = 64;
    private static final int HEIGHT = 36;
    private static final int TICKS = 12;

    /** What a picture of this size does not show is left out. */
    private static final Quality LOWEST = Quality.LOW
            .with("pictureResolution", 1)
            .with("shadowTexels", 256)
            .with("cloudSkyboxTexels", 64)
            .with("cloudLightCell", 4);

    /** What no user should read: names of exceptions, and records as text. */
    private static final Pattern JAVA = Pattern.compile("Exception|\\b[A-Z]\\w+\\[\\w+=|\\bnull\\b|@[0-9a-f]{5,}");

    private final Path file;
    private Outcome outcome = Outcome.REFUSED;

    /** @param folder with the pictures of {@link InputLevels}; a level is written into it */
    InputTrial(Path folder) {
        file = folder.resolve("level.json");
    }

    /** Returns what became of the last level. */
    Outcome outcome() {
        return outcome;
    }

    /**
     * Uses a level and returns what went wrong, in words.
     *
     * @param gl {@code null} for a level that is not drawn
     */
    Optional<String> run(InputLevels.OddInput input, GlContext gl) {
        outcome = Outcome.REFUSED;
        try {
            Level level = checked(input);
            if (level == null) {
                return Optional.empty();
            }
            outcome = Outcome.ACCEPTED;
            saved(level);
            PlacedLevel placed = PlacedLevel.of(level, LevelAssets.beside(file));
            FramePlan.of(FrameRequest.of(placed, QualityChoice.defaultOutput(level)))
                    .explain();
            simulated(placed);
            if (gl != null) {
                CloudExplanation.lines(placed);
                drawn(placed, input.seconds(), gl);
                outcome = Outcome.DRAWN;
            }
            return Optional.empty();
        } catch (Fault fault) {
            return Optional.of(fault.getMessage());
        } catch (Exception | StackOverflowError | OutOfMemoryError crash) {
            return Optional.of(reported(crash));
        }
    }

    private static String reported(Throwable crash) {
        StackTraceElement[] trace = crash.getStackTrace();
        return crash + (trace.length == 0 ? "" : " at " + trace[0]);
    }

    /** Returns the level; {@code null} if it is refused as it should be. */
    private Level checked(InputLevels.OddInput input) throws Fault {
        Level level;
        try {
            level = LevelJson.read(file.toString(), input.utf8());
        } catch (LevelFormatException refusal) {
            for (Problem problem : refusal.problems()) {
                reported(problem);
                boolean isThere = input.numbers().keySet().stream()
                        .anyMatch(place -> place.path().startsWith(problem.path()));
                if (!isThere) {
                    throw new Fault("names another place: " + problem.line("level.json"));
                }
            }
            return null;
        }
        if (!input.isInRange()) {
            throw new Fault("is read although a number is outside its range");
        }
        List<Problem> problems;
        try {
            problems = LevelRules.check(level, LevelAssets.beside(file));
        } catch (AssetException wrong) {
            throw new Fault("is refused without a place: " + wrong.getMessage());
        }
        for (Problem problem : problems) {
            reported(problem);
        }
        return problems.stream().anyMatch(Problem::isError) ? null : level;
    }

    private static void reported(Problem problem) throws Fault {
        String line = problem.line("level.json");
        if (problem.path().equals("$")
                || problem.path().isEmpty()
                || JAVA.matcher(line).find()) {
            throw new Fault("is told without a place, or in words of Java: " + line);
        }
    }

    private void saved(Level level) throws Fault {
        LevelFile.save(file, level);
        if (!LevelFile.read(file).equals(level)) {
            throw new Fault("is read back as another level");
        }
    }

    /** Walks, and fires both portals if there is a gun. */
    private static void simulated(PlacedLevel placed) throws Fault {
        Simulation simulation = new Simulation(SimLevel.of(placed), SimSettings.DEFAULT);
        SimState state = simulation.start();
        for (int tick = 0; tick < TICKS; tick++) {
            Action fired = tick < TICKS / 2 ? Action.FIRE_FIRST : Action.FIRE_SECOND;
            state = simulation.step(state, PlayerInput.FORWARD.holding(fired));
        }
        Vec3 feet = state.player().feet();
        if (!Double.isFinite(feet.x() + feet.y() + feet.z())) {
            throw new Fault("puts the player at " + feet.x() + ", " + feet.y() + ", " + feet.z());
        }
    }

    private void drawn(PlacedLevel placed, double seconds, GlContext gl) throws Fault {
        Scene scene = Scene.of(placed, LevelLight.of(placed, done -> {}));
        RenderSettings settings = RenderSettings.of(Output.HDR, LOWEST);
        try (RenderTarget target = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, WIDTH, HEIGHT);
                Renderer renderer = LevelRenderer.load(gl, scene, settings)) {
            FrameState state = FrameState.atStart(renderer.scene().level());
            state.seconds(seconds);
            double aspect = (double) WIDTH / HEIGHT;
            renderer.draw(
                    Viewpoints.standard(placed.level(), file.toString(), aspect).apply(0), state, target);
            gl.requireNoError("draw");
            float[] radiance = renderer.readRadiance();
            for (int i = 0; i < radiance.length; i++) {
                if (!Float.isFinite(radiance[i])) {
                    throw new Fault("pixel " + i / 3 + " is " + radiance[i]);
                }
            }
        }
    }
}
