package nephele.host.playthrough;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Vec3;
import nephele.engine.portal.CrossingWord;
import nephele.engine.portal.Portals;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.GunInHand;
import nephele.engine.scene.ShotPalette;
import nephele.engine.scene.View;
import nephele.engine.sim.FixedStep;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.GunPortals;
import nephele.engine.sim.state.PlayerState;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.WorldState.FallState;
import nephele.host.named.Viewpoints;
import org.joml.Vector3d;

/**
 * The simulated part of a game: two states between which frames interpolate, the clock that makes ticks and the record
 * of all input.
 */
public final class Playthrough {
    /** A displacement longer by this than the velocities account for is a discontinuity: the player was reset. */
    private static final double LEAP_METRES = 1;

    private static final double LEAST_DEPTH_METRES = 0.1;

    private static final long NEVER = Long.MIN_VALUE / 2;

    /** How much farther than the camera the body of a character sinks that is seen from behind. */
    private static final double BODY_DIP_FRACTION = 2;

    /** Time in which a held body becomes transparent, or opaque again when the camera leaves the eye. */
    private static final double CLEARING_SECONDS = 0.2;

    private final Simulation simulation;
    private final double secondsPerTick;
    private final TickInput input;
    private final ReplayRecorder recorder;
    private final FixedStep clock;
    private final List<TickEvent> news = new ArrayList<>();
    private final PortalAges ages;
    private final FrameInterpolation live;
    private final CameraBoom boom;
    private final ShotPreviews aiming;
    private final HintClock hints;
    private final ShotEffects shots;
    private final boolean hasGun;
    private double verticalFovDegrees = Viewpoints.PLAYER_FOV_DEGREES;
    /** The crosshair of first person, kept while it is the same. */
    private CrosshairState middle = CrosshairState.MIDDLE;

    private SimState before;
    private SimState after;
    private PlayerPose viewedFrom;
    private double viewFovDegrees;
    private View view;
    private FrameCamera frameCamera;
    private Vec3 heldFromEye;
    private double heldClarity;
    private boolean isCut = true;
    private ObserverView observer;
    private AnimationState animationBefore = AnimationState.STANDING;
    private AnimationState animationAfter = AnimationState.STANDING;
    private GunMotion gunBefore = GunMotion.AT_REST;
    private GunMotion gunAfter = GunMotion.AT_REST;
    private LandingDip dipBefore = LandingDip.NONE;
    private LandingDip dipAfter = LandingDip.NONE;
    private PictureMotion motion = PictureMotion.FULL;
    private long leaptInTick = NEVER;

    /**
     * The start of a walk and the name in its recording.
     *
     * @param levelFile file of the level, as the recording names it
     * @param from {@code null} for the start of the level
     */
    public record Beginning(String levelFile, SimSettings settings, PlayerStart from) {}

    /** Starts a walk through a level without models. */
    public Playthrough(Level level, Beginning beginning, TickInput input) {
        this(level, SimLevel.of(level), beginning, input);
    }

    /**
     * Starts a walk through a level.
     *
     * @param simLevel made from the level
     */
    public Playthrough(Level level, SimLevel simLevel, Beginning beginning, TickInput input) {
        this.input = input;
        simulation = new Simulation(simLevel, beginning.settings);
        SimState start = beginning.from == null ? simulation.start() : simulation.startFrom(beginning.from);
        secondsPerTick = 1.0 / beginning.settings.ticksPerSecond();
        recorder = new ReplayRecorder(beginning.levelFile, beginning.settings, beginning.from);
        clock = new FixedStep(beginning.settings.ticksPerSecond());
        before = start;
        after = start;
        ages = new PortalAges(start, secondsPerTick);
        live = new FrameInterpolation(level);
        boom = new CameraBoom(simLevel.statics(), secondsPerTick);
        aiming = new ShotPreviews(simulation);
        hints = new HintClock(level.hints(), secondsPerTick);
        shots = new ShotEffects(boom, secondsPerTick);
        hasGun = level.portalGun() != null;
    }

    /** Shows the walk before an observer's camera; {@code null} for the player's view. */
    public void observe(ObserverView from) {
        observer = from;
    }

    /** Returns the observer's view; {@code null} without one. */
    public ObserverView observer() {
        return observer;
    }

    /** Simulates the ticks that are due after a frame of this length. */
    public void advance(long elapsedNanos) {
        int due = clock.advance(elapsedNanos);
        for (int i = 0; i < due; i++) {
            tick();
        }
    }

    /** Returns the simulated time of a tick. */
    public double secondsPerTick() {
        return secondsPerTick;
    }

    /** Sets the colours of the shots' portals. */
    public void shotPalette(ShotPalette palette) {
        live.frameState().shotPalette(palette);
    }

    /** Sets how flashes of lightning come and go. */
    public void flashStyle(FlashStyle style) {
        live.frameState().flashStyle(style);
    }

    /** Sets how much the picture moves by itself. */
    public void motion(PictureMotion chosen) {
        motion = chosen;
    }

    /** Sets the vertical field of view of {@link #view}. */
    public void verticalFovDegrees(double degrees) {
        verticalFovDegrees = degrees;
    }

    /** Returns the real time that was not simulated because frames took longer than 0.25 s. */
    public long lostNanos() {
        return clock.lostNanos();
    }

    /** Simulates one tick. */
    public void tick() {
        var done = input.next();
        recorder.record(done);
        before = after;
        after = simulation.step(after, done);
        if (!after.world().trace().events().isEmpty()) {
            news.addAll(after.world().trace().events());
        }
        ages.after(after);
        aiming.after(after);
        hints.tick(after.player().centre());
        fadeHeld(PlayerPose.heldFromEye(after));
        animationBefore = animationAfter;
        animationAfter = animationAfter.next(after, secondsPerTick);
        gunBefore = gunAfter;
        gunAfter = gunAfter.next(before, after, secondsPerTick);
        dipBefore = dipAfter;
        dipAfter = dipAfter.next(before, after, secondsPerTick);
        shots.after(before, after, Math.tan(Math.toRadians(verticalFovDegrees) / 2));
        if (isDiscontinuity()) {
            leap();
        } else {
            boom.tick(before, after);
        }
    }

    /** Begins anew after a discontinuity. */
    private void leap() {
        before = after;
        animationBefore = animationAfter;
        gunBefore = gunAfter;
        dipAfter = LandingDip.NONE;
        dipBefore = dipAfter;
        shots.cut();
        boom.cut();
        leaptInTick = after.tick();
        isCut = true;
    }

    /** Returns how dark the picture is for a fall out of the level and after it, 0 (as always) to 1 (black). */
    public double darkness() {
        if (motion == PictureMotion.REDUCED) {
            return 0;
        }
        double ticks = after.tick() + clock.fraction();
        double leapt = 1 - (ticks - leaptInTick) * secondsPerTick / FallState.FADE_SECONDS;
        int ticksPerSecond = (int) Math.round(1 / secondsPerTick);
        return Math.max(after.world().fall().darkness(ticks, ticksPerSecond), Math.max(0, Math.min(1, leapt)));
    }

    private boolean isDiscontinuity() {
        PlayerState from = before.player();
        PlayerState to = after.player();
        CrossingWord crossed = after.world().trace().playerCrossed();
        Portals portals = after.world().portals();
        Vec3 place = from.centre();
        for (int i = 0; i < crossed.length(); i++) {
            place = portals.transform(crossed.entry(i)).point(place);
        }
        double metres = to.centre().minus(place).length();
        double speed = from.velocity().length() + to.velocity().length();
        return metres > LEAP_METRES + speed * secondsPerTick;
    }

    /** Returns the events since the last call. */
    public List<TickEvent> takeEvents() {
        if (news.isEmpty()) {
            return List.of();
        }
        List<TickEvent> taken = List.copyOf(news);
        news.clear();
        return taken;
    }

    /**
     * Returns true if the view is discontinuous with the one before: at first, and after a reset of the player. Clears
     * the flag.
     */
    public boolean takeCut() {
        boolean was = isCut;
        isCut = false;
        return was;
    }

    /** Returns true when the input is a replay that has no further tick. */
    public boolean isFinished() {
        return input.isFinished();
    }

    /** Returns the state after the last tick. */
    public SimState state() {
        return after;
    }

    /** Returns the record of all input so far. */
    public ReplayRecorder recorder() {
        return recorder;
    }

    /** Returns the level's hints as this walk has earned and taken them. */
    public HintClock hints() {
        return hints;
    }

    /** Returns true if the player would pick up a body now. */
    public boolean canPickUp() {
        return simulation.canPickUp(after);
    }

    /** Switches between first and third person; before an observer's camera to the next bounds. */
    public void changePerson() {
        if (observer == null) {
            boom.toggle();
        } else {
            observer.nextBounds();
        }
    }

    /** Returns the player's view between the last two ticks: from the eye, the camera boom or an observer's camera. */
    public View view(double aspect) {
        if (observer != null) {
            return observer.view(aspect);
        }
        PlayerPose camera = frameCamera().camera();
        boolean isSame = view != null
                && viewedFrom == camera
                && view.projection().aspect() == aspect
                && viewFovDegrees == verticalFovDegrees;
        if (!isSame) {
            viewedFrom = camera;
            viewFovDegrees = verticalFovDegrees;
            view = Viewpoints.ofEye(camera.eye(), camera.view(), verticalFovDegrees, aspect);
        }
        return view;
    }

    /** Returns the crosshair of the last view, for a picture of this size. */
    public CrosshairState sights(double widthPoints, double heightPoints) {
        CrosshairState.Half first = aiming.half(after, GunPortals.Colour.FIRST);
        CrosshairState.Half second = aiming.half(after, GunPortals.Colour.SECOND);
        FrameCamera now = frameCamera();
        if (now.isFirstPerson()) {
            if (middle.first() != first || middle.second() != second) {
                middle = new CrosshairState(0, 0, first, second);
            }
            return middle;
        }
        View view = view(widthPoints / heightPoints);
        Vec3 towards = now.aimed().minus(view.eye());
        double depth = Math.max(-towards.dot(view.back()), LEAST_DEPTH_METRES);
        double pointsPerUnit = heightPoints / 2 / (view.projection().tanHalfHeight() * depth);
        return new CrosshairState(
                toHalves(towards.dot(view.right()) * pointsPerUnit),
                toHalves(-towards.dot(view.up()) * pointsPerUnit),
                first,
                second);
    }

    /** Rounds to half points: the overlay is redrawn whenever it changes. */
    private static double toHalves(double points) {
        return Math.rint(2 * points) / 2 + 0.0;
    }

    /** Returns the frame state between the last two ticks; always the same object. */
    public FrameState frameState() {
        double fraction = clock.fraction();
        double seconds = Math.max(0, after.tick() - 1 + fraction) * secondsPerTick;
        live.frameState().previews(aiming.previews(after));
        live.world(before, after, fraction, ages);
        live.frameState().closing(ages.closing(after.tick(), fraction));
        live.frameState().shotEffects(shots.at(after.tick(), fraction));
        live.frameState()
                .muzzleLight(shots.muzzleLight(
                        after.tick(), fraction, live.frameState().flashStyle()));
        live.held(after, heldFromCamera(fraction), observer == null ? heldClarity : 0);
        if (observer != null) {
            live.frameState().observer(observer.sphere(frameCamera().player().body(), after.player()));
        }
        AnimationState animation = animationBefore.towards(animationAfter, fraction);
        double dip = dip(fraction);
        live.frameState().gun(gun(animation, fraction, dip));
        live.character(frameCamera().player(), animation, boom.isOut() ? BODY_DIP_FRACTION * dip : dip, seconds);
        return live.frameState();
    }

    /** Returns the gun in the player's hand; {@code null} without one, and if it is not the player's eye that sees. */
    private GunInHand gun(AnimationState animation, double fraction, double dip) {
        if (!hasGun || observer != null || boom.isOut()) {
            return null;
        }
        var moment = new GunMotion.Moment(
                after.tick(),
                fraction,
                secondsPerTick,
                motion,
                live.frameState().flashStyle());
        return gunBefore.at(moment, gunAfter, animation, dip);
    }

    /** Returns by how much the eye is below its usual height after a landing, metres. */
    private double dip(double fraction) {
        return motion == PictureMotion.REDUCED ? 0 : dipBefore.metres(dipAfter, fraction);
    }

    /** @param fromEye position of the held body, {@code null} for none, which is never transparent */
    private void fadeHeld(Vec3 fromEye) {
        double step = (boom.isOut() ? -1 : 1) * secondsPerTick / CLEARING_SECONDS;
        heldFromEye = fromEye;
        heldClarity = fromEye == null ? 0 : Math.max(0, Math.min(1, heldClarity + step));
    }

    /** Returns the held body's position relative to the camera, also while the camera leaves the eye. */
    private Vec3 heldFromCamera(double fraction) {
        if (heldClarity == 0 || !boom.isOut()) {
            return heldFromEye;
        }
        return Vec3.of(
                heldFromEye.toVector().sub(boom.offset(before, after, fraction).toVector()));
    }

    /**
     * The camera of a frame, and the hit of a shot from the eye.
     *
     * @param aimed in the camera's space
     */
    private record FrameCamera(
            SimState after, double fraction, boolean isFirstPerson, PlayerPose player, PlayerPose camera, Vec3 aimed) {}

    /** Returns a pose with its eye lowered; an eye beyond a portal stays where it is. */
    private static PlayerPose dipped(PlayerPose pose, double metres) {
        PlayerPose.Body body = pose.body();
        boolean isTogether = pose.eye().equals(body.eye());
        return metres == 0 || !isTogether
                ? pose
                : new PlayerPose(pose.eye().addScaled(-metres, body.up()), pose.view(), body, pose.later());
    }

    /** Returns the view, shared by the picture, the frame state and the crosshair of one frame. */
    private FrameCamera frameCamera() {
        double fraction = clock.fraction();
        if (frameCamera == null
                || frameCamera.after != after
                || frameCamera.fraction != fraction
                || frameCamera.isFirstPerson() == boom.isOut()) {
            PlayerPose player = PlayerPose.between(before, after, fraction);
            boolean isOut = boom.isOut();
            Vector3d aimed = isOut ? boom.aimedAt(player) : new Vector3d();
            PlayerPose camera = isOut ? boom.camera(before, after, fraction, aimed) : dipped(player, dip(fraction));
            frameCamera = new FrameCamera(after, fraction, !isOut, player, camera, Vec3.of(aimed));
        }
        return frameCamera;
    }
}
