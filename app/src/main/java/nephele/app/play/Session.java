package nephele.app.play;

import java.util.Optional;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.window.Input;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.View;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.FollowingBake;
import nephele.host.draw.Preparation;
import nephele.host.playthrough.ObserverView;
import nephele.host.playthrough.Playthrough;
import nephele.host.playthrough.ReplayInput;
import nephele.host.playthrough.TakenOverInput;
import nephele.host.playthrough.TickInput;

/** One level being played: its picture and its simulation. */
final class Session implements AutoCloseable {
    /** The way of the title's camera to each side, and its speed. */
    private static final double SWAY_METRES = 0.35;

    private static final double SWAY_RADIANS_PER_SECOND = 0.25;

    private final PlayRequest request;
    private Preparation.Prepared prepared;
    private final Level level;
    private final SimLevel world;
    private SessionPicture picture;
    private final Input input;
    private final Optional<String> notice;
    private Playthrough playthrough;

    private Session(PlayRequest request, Preparation.Prepared prepared, SessionPicture picture, Input input) {
        this.request = request;
        this.prepared = prepared;
        this.level = prepared.opened().level();
        this.world = prepared.world();
        this.notice = prepared.opened().notice();
        this.picture = picture;
        this.input = input;
        restart();
    }

    /**
     * Builds the resources of a level; its problems are thrown before anything is allocated.
     *
     * @param automatic the quality in place of the request's
     */
    static Session load(
            GlContext gl, PlayRequest request, Preparation preparation, Input input, Optional<Quality> automatic) {
        return load(gl, request, preparation.get(), input, automatic);
    }

    /** Builds the resources of a prepared level. */
    static Session load(
            GlContext gl,
            PlayRequest request,
            Preparation.Prepared prepared,
            Input input,
            Optional<Quality> automatic) {
        return new Session(request, prepared, SessionPicture.load(gl, request, prepared, automatic), input);
    }

    /** Restarts the level; a replay uses its own settings. */
    void restart() {
        var replay = request.replay();
        SimSettings settings = replay != null ? replay.settings() : request.settings();
        var from = request.from() == null && replay != null ? replay.start() : request.from();
        playthrough = new Playthrough(
                level, world, new Playthrough.Beginning(request.level().fileName(), settings, from), hands());
        playthrough.observe(ObserverView.of(level, prepared.scene().statics().models()));
        apply();
    }

    private TickInput hands() {
        var device = new LiveInput(input, request.player().files()::settings);
        TickInput live = level.observer() == null ? device : device.unturned();
        if (request.shown() == null) {
            return live;
        }
        return request.shown().isTakenOver()
                ? new TakenOverInput(request.replay(), request.shown().takeOverTick(), live, input::forgetMouse)
                : new ReplayInput(request.replay());
    }

    /** Applies the player's settings that hold at once. */
    void apply() {
        GameSettings settings = request.player().files().settings();
        playthrough.verticalFovDegrees(settings.verticalFovDegrees());
        playthrough.shotPalette(settings.get(Settings.PORTAL_COLOURS));
        playthrough.flashStyle(settings.flashStyle());
        playthrough.motion(settings.motion());
    }

    /**
     * Replaces the renderer.
     *
     * @param automatic the quality in place of the request's
     */
    void redraw(GlContext gl, Optional<Quality> automatic) {
        SessionPicture next = SessionPicture.load(gl, request, prepared, automatic);
        next.follow(picture);
        picture.close();
        picture = next;
    }

    /** Replaces the scene by one of the same level with other light. */
    void relight(Scene scene) {
        if (isOtherLight(scene)) {
            picture.edit(scene);
            prepared = prepared.with(scene);
        }
    }

    /** Returns true if {@link #relight} would change something. */
    boolean isOtherLight(Scene scene) {
        return scene != prepared.scene();
    }

    /** Starts to bake the light that the level lacks; see {@link FollowingBake}. */
    FollowingBake bake() {
        return FollowingBake.begin(prepared.scene(), request.chosenQuality().drawn(prepared.opened()));
    }

    /** Returns the replay since the start or the last restart, with its track: it is simulated again. */
    Replay trackedRecording() {
        var replay = recording();
        return replay.tracked(new Simulation(world, replay.settings()));
    }

    /** Returns the level as prepared. */
    Preparation.Prepared prepared() {
        return prepared;
    }

    /** Returns true if the player, not a replay, moves the character. */
    boolean isInPlayersHands() {
        return request.shown() == null
                || playthrough.state().tick() >= request.shown().takeOverTick();
    }

    PlayRequest request() {
        return request;
    }

    Level level() {
        return level;
    }

    /**
     * Returns the view behind the title: from the level's first camera, which sways slowly.
     *
     * @param seconds since the title was opened
     */
    View titleView(double aspect, double seconds) {
        if (level.cameras().isEmpty()) {
            return playthrough.view(aspect);
        }
        Camera camera = level.cameras().get(0);
        Vec3 target =
                camera.path().isEmpty() ? camera.target() : camera.path().get(0).target();
        View still = View.ofCamera(camera, 0, aspect);
        Vec3 eye = still.eye()
                .addScaled(SWAY_METRES * Math.sin(seconds * SWAY_RADIANS_PER_SECOND), still.right())
                .addScaled(SWAY_METRES / 2 * Math.sin(seconds * SWAY_RADIANS_PER_SECOND * 0.7), still.up());
        return View.lookAt(eye, target, new Vec3(0, 1, 0), still.projection());
    }

    /** Returns the level as the title shows it: no gun is in the hand of an eye that is not the player's. */
    FrameState titleState() {
        FrameState state = playthrough.frameState();
        if (!level.cameras().isEmpty()) {
            state.gun(null);
        }
        return state;
    }

    Playthrough walk() {
        return playthrough;
    }

    /** Returns the replay since the start or the last restart. */
    Replay recording() {
        return playthrough.recorder().replay().recordedIn(level);
    }

    Renderer renderer() {
        return picture.renderer();
    }

    /** Returns what draws the level. */
    SessionPicture picture() {
        return picture;
    }

    Optional<String> notice() {
        return notice;
    }

    @Override
    public void close() {
        picture.close();
    }
}
