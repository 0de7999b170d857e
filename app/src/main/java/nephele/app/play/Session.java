package nephele.app.play;

import java.util.Optional;
import nephele.app.window.Input;
import nephele.engine.draw.Preparation;
import nephele.engine.level.Level;
import nephele.engine.named.AssetProblems;
import nephele.engine.playthrough.Playthrough;
import nephele.engine.playthrough.ReplayInput;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;

/** One level being played: its renderer and its simulation. */
final class Session implements AutoCloseable {
    private final PlayRequest request;
    private final Level level;
    private final SimLevel world;
    private final Renderer renderer;
    private final Input input;
    private final Optional<String> notice;
    private Playthrough playthrough;

    private Session(PlayRequest request, Preparation.Prepared prepared, Renderer renderer, Input input) {
        this.request = request;
        this.level = prepared.opened().level();
        this.world = prepared.world();
        this.notice = prepared.opened().notice();
        this.renderer = renderer;
        this.input = input;
        restart(request.simulation());
    }

    /** Builds the resources of a level; its problems are thrown before anything is allocated. */
    static Session load(GlContext gl, PlayRequest request, Preparation preparation, Input input) {
        var prepared = preparation.get();
        return new Session(request, prepared, renderer(gl, request, prepared), input);
    }

    static Renderer renderer(GlContext gl, PlayRequest request, Preparation.Prepared prepared) {
        var output = request.quality().output(prepared.opened().level());
        var settings =
                request.quality().settings(output, gl.limits().software()).with(CharacterPresence.POSSIBLE);
        return AssetProblems.named(prepared.opened(), () -> Renderer.load(gl, prepared.scene(), settings));
    }

    /** Restarts the level; a replay uses its own settings. */
    void restart(SimSettings asked) {
        var replay = request.replay();
        SimSettings settings = replay != null ? replay.settings() : asked;
        var from = request.from() == null && replay != null ? replay.start() : request.from();
        var hands = replay != null ? new ReplayInput(replay) : new LiveInput(input);
        playthrough = new Playthrough(
                level, world, new Playthrough.Beginning(request.level().fileName(), settings, from), hands);
    }

    /** Returns in words when changed settings take effect. */
    String settingsHold() {
        return request.settingsHold();
    }

    Playthrough walk() {
        return playthrough;
    }

    /** Returns the replay since the start or the last restart. */
    Replay recording() {
        return playthrough.recorder().replay().recordedIn(level);
    }

    Renderer renderer() {
        return renderer;
    }

    Optional<String> notice() {
        return notice;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
