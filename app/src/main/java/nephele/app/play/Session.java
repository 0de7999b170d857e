package nephele.app.play;

import java.util.Optional;
import nephele.app.window.Input;
import nephele.engine.draw.Preparation;
import nephele.engine.level.Level;
import nephele.engine.named.AssetComplaint;
import nephele.engine.render.Renderer;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.thing.FigurePresence;
import nephele.engine.sim.Replay;
import nephele.engine.sim.SimLevel;
import nephele.engine.sim.SimSettings;
import nephele.engine.walk.ReplayInput;
import nephele.engine.walk.Walk;

/** One level being played: its renderer and its simulation. */
final class Session implements AutoCloseable {
    private final PlayRequest request;
    private final Level level;
    private final SimLevel world;
    private final Renderer renderer;
    private final Input input;
    private final Optional<String> notice;
    private Walk walk;

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
                request.quality().settings(output, gl.limits().software()).with(FigurePresence.POSSIBLE);
        return AssetComplaint.named(prepared.opened(), () -> Renderer.load(gl, prepared.scene(), settings));
    }

    /** Restarts the level; a replay uses its own settings. */
    void restart(SimSettings asked) {
        var replay = request.replay();
        SimSettings settings = replay != null ? replay.settings() : asked;
        var from = request.from() == null && replay != null ? replay.start() : request.from();
        var hands = replay != null ? new ReplayInput(replay) : new LiveInput(input);
        walk = new Walk(level, world, new Walk.Beginning(request.level().fileName(), settings, from), hands);
    }

    /** Returns in words when changed settings take effect. */
    String settingsHold() {
        return request.settingsHold();
    }

    Walk walk() {
        return walk;
    }

    /** Returns the replay since the start or the last restart. */
    Replay recording() {
        return walk.recorder().replay().recordedIn(level);
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
