package nephele.engine.sim;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;

/** A level of models in the form that an author writes, and the player in it. */
final class ModelRoom {
    private final List<String> models = new ArrayList<>();
    private final List<String> solids = new ArrayList<>();
    private final List<String> bodies = new ArrayList<>();
    private String rest = "";
    private String player = "\"feet\": [0, 0, 0]";
    private Simulation simulation;
    private SimState state;

    /** @param steps the steps of the transform, without brackets */
    ModelRoom model(String file, String steps) {
        return model(file, steps, "");
    }

    ModelRoom model(String file, String steps, String more) {
        models.add("{\"id\": \"m" + models.size() + "\", \"file\": \"" + file + "\", \"transform\": [" + steps + "]"
                + more + "}");
        return this;
    }

    static String translate(double x, double y, double z) {
        return "{\"kind\": \"translate\", \"by\": [" + x + ", " + y + ", " + z + "]}";
    }

    static String rotate(String axis, double degrees) {
        return "{\"kind\": \"rotate\", \"axis\": " + axis + ", \"angleDegrees\": " + degrees + "}";
    }

    static String scale(double x, double y, double z) {
        return "{\"kind\": \"scale\", \"by\": [" + x + ", " + y + ", " + z + "]}";
    }

    ModelRoom box(double x, double y, double z, double sizeX, double sizeY, double sizeZ) {
        solids.add("{\"id\": \"s" + solids.size() + "\", \"kind\": \"box\", \"centre\": [" + x + ", " + y + ", " + z
                + "], \"size\": [" + sizeX + ", " + sizeY + ", " + sizeZ + "]}");
        return this;
    }

    /** Adds a floor with its top at y = 0. */
    ModelRoom floor() {
        return box(0, -0.5, 0, 60, 1, 60);
    }

    ModelRoom cube(double x, double y, double z, double edge) {
        bodies.add("{\"id\": \"b" + bodies.size() + "\", \"kind\": \"box\", \"massKilograms\": 10, \"centre\": [" + x
                + ", " + y + ", " + z + "], \"size\": [" + edge + ", " + edge + ", " + edge + "]}");
        return this;
    }

    ModelRoom gun() {
        rest += ", \"portalGun\": {}";
        return this;
    }

    ModelRoom startAt(double x, double y, double z) {
        player = "\"feet\": [" + x + ", " + y + ", " + z + "]";
        return this;
    }

    Simulation simulation() {
        if (simulation == null) {
            String text = "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {" + player + "}, \"solids\": "
                    + solids + ", \"bodies\": " + bodies + ", \"models\": " + models + rest + "}";
            var level = LevelJson.read("room.json", text.getBytes(StandardCharsets.UTF_8));
            simulation = new Simulation(SimLevel.of(PlacedLevel.of(level, NoFiles.AT_ALL)), SimSettings.DEFAULT);
            state = simulation.start();
        }
        return simulation;
    }

    SimState state() {
        simulation();
        return state;
    }

    Vec3 feet() {
        return state().player().feet();
    }

    Vec3 body(int body) {
        return state().world().bodies().state(body).centre();
    }

    ModelRoom hold(PlayerInput input, double seconds) {
        return hold(input, seconds, ignored -> {});
    }

    ModelRoom hold(PlayerInput input, double seconds, Consumer<SimState> look) {
        simulation();
        for (long i = 0; i < Math.round(seconds * 120); i++) {
            state = simulation.step(state, input);
            look.accept(state);
        }
        return this;
    }

    ModelRoom press(Action action) {
        return hold(PlayerInput.NONE.holding(action), 1 / 120.0).hold(PlayerInput.NONE, 1 / 120.0);
    }

    ModelRoom turn(double leftDegrees, double upDegrees) {
        return hold(
                PlayerInput.NONE.turning((int) Math.round(1000 * leftDegrees), (int) Math.round(1000 * upDegrees)),
                1 / 120.0);
    }
}
