package nephele.engine.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.math.Basis;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The frame state: everything drawn that changes, namely portals, bodies, the player's character and the environment
 * light at one instant. The game fills it before each frame; one object serves all frames.
 */
public final class FrameState {
    /** Doubles per body: centre, then orientation x y z w. */
    private static final int STRIDE = 7;

    /** Stands for the absence of a body's index. */
    public static final int NOTHING = -1;

    private final double[] bodies;
    private final Environment authored;
    private Environment environment;
    private double seconds;
    private Portals portals;
    private double[] openness;
    private int[] colours;
    private Posture character;
    private ObserverSphere observer;
    private List<PortalPreview> previews = List.of();
    private List<ClosingPortal> closing = List.of();
    private List<ShotEffect> shotEffects = List.of();
    private MuzzleLight muzzleLight;
    private GunInHand gun;
    private int held = NOTHING;
    private Vec3 heldFromEye = Vec3.ZERO;
    private double heldClarity;
    private ShotPalette shotPalette = ShotPalette.BLUE_ORANGE;
    private FlashStyle flashStyle = FlashStyle.NATURAL;
    private Map<String, Double> layerGains = Map.of();

    private FrameState(Environment environment, int bodyCount) {
        authored = environment;
        this.environment = Daylight.at(environment, 0);
        bodies = new double[STRIDE * bodyCount];
    }

    /**
     * Returns the state of a level before its first tick: its own portals are open, its bodies are at their initial
     * positions and there is no player.
     */
    public static FrameState atStart(Level level) {
        FrameState start = new FrameState(level.environment(), level.bodies().size());
        for (int i = 0; i < level.bodies().size(); i++) {
            Body body = level.bodies().get(i);
            start.body(i, body.centre().toVector(), new Quaterniond());
        }
        start.portals(Portals.of(level));
        Vec3 centre = level.observerStart();
        start.observer = centre == null
                ? null
                : new ObserverSphere(centre, level.observer().radiusMetres(), false);
        return start;
    }

    /** Returns the environment light at this instant. */
    public Environment environment() {
        return environment;
    }

    /**
     * Sets another environment light, such as that of another hour.
     *
     * @param now differs from the level's only in the sun's direction and irradiance, the sky's radiance and the
     *     exposure; of a sky that does not move, the moon lights the air between eye and surfaces only if it does in
     *     the level
     */
    public void environment(Environment now) {
        environment = now;
    }

    /** Returns the simulated time in seconds; it drives self-moving effects. */
    public double seconds() {
        return seconds;
    }

    /** Sets the simulated time; a sun that moves follows it. */
    public void seconds(double now) {
        seconds = now;
        if (Daylight.moves(authored)) {
            Environment later = Daylight.at(authored, now);
            environment = later.equals(environment) ? environment : later;
        }
    }

    /** Returns the colours of the shots' portals. */
    public ShotPalette shotPalette() {
        return shotPalette;
    }

    /** Sets the colours of the shots' portals. */
    public void shotPalette(ShotPalette now) {
        shotPalette = now;
    }

    /** Returns how flashes of lightning come and go. */
    public FlashStyle flashStyle() {
        return flashStyle;
    }

    /** Sets how flashes of lightning come and go. */
    public void flashStyle(FlashStyle now) {
        flashStyle = now;
    }

    /** Returns the gains of named layers of light; 1 for the others. */
    public Map<String, Double> layerGains() {
        return layerGains;
    }

    /** Sets the gains of layers of light by their names, 0 for dark. */
    public void layerGains(Map<String, Double> now) {
        layerGains = now;
    }

    public Portals portals() {
        return portals;
    }

    /** Replaces the portals; new ones are fully open and have the colour {@code 2 + index}. */
    public void portals(Portals now) {
        if (now == portals) {
            return;
        }
        portals = now;
        openness = new double[now.size()];
        colours = new int[now.size()];
        Arrays.fill(openness, 1);
        Arrays.setAll(colours, portal -> 2 + portal);
    }

    /**
     * Returns the fraction to which a portal has opened since it was made, 0 to 1; its aperture is drawn scaled by it.
     */
    public double openness(int portal) {
        return openness[portal];
    }

    /** Returns the colour of a portal: 0 or 1 for the two shots, 2 and more for the level's portals. */
    public int colour(int portal) {
        return colours[portal];
    }

    public void setPortalLook(int portal, int colour, double open) {
        colours[portal] = colour;
        openness[portal] = open;
    }

    public int bodies() {
        return bodies.length / STRIDE;
    }

    public void body(int index, Vector3dc centre, Quaterniondc worldFromBody) {
        int at = STRIDE * index;
        bodies[at] = centre.x();
        bodies[at + 1] = centre.y();
        bodies[at + 2] = centre.z();
        bodies[at + 3] = worldFromBody.x();
        bodies[at + 4] = worldFromBody.y();
        bodies[at + 5] = worldFromBody.z();
        bodies[at + 6] = worldFromBody.w();
    }

    public Vector3d centre(int body, Vector3d out) {
        int at = STRIDE * body;
        return out.set(bodies[at], bodies[at + 1], bodies[at + 2]);
    }

    /** Sets {@code out} to the rotation from the body's frame to the world. */
    public Quaterniond orientation(int body, Quaterniond out) {
        int at = STRIDE * body + 3;
        return out.set(bodies[at], bodies[at + 1], bodies[at + 2], bodies[at + 3]);
    }

    /** Returns the posture of the player's character, {@code null} if no character is drawn. */
    public Posture character() {
        return character;
    }

    public void character(Posture now) {
        character = now;
    }

    /** Returns the sphere that billboards face; {@code null} if they face the eye. */
    public ObserverSphere observer() {
        return observer;
    }

    public void observer(ObserverSphere now) {
        observer = now;
    }

    /** Returns the body that its holder's eye sees, or {@link #NOTHING}; it is drawn transparent. */
    public int held() {
        return held;
    }

    /**
     * Returns the offset of {@link #held} from the eye in metres to its right, up and back, measured along the portals
     * through which the body is held.
     */
    public Vec3 heldFromEye() {
        return heldFromEye;
    }

    /** Returns the transparency reached: 0 for opaque, 1 for the greatest transparency. */
    public double heldClarity() {
        return heldClarity;
    }

    public void held(int body, Vec3 fromEye, double clarity) {
        held = body;
        heldFromEye = fromEye;
        heldClarity = clarity;
    }

    /** Ends the transparency of the held body. */
    public void nothingHeld() {
        held = NOTHING;
    }

    /** Returns the previews of the portals that shots would open now. */
    public List<PortalPreview> previews() {
        return previews;
    }

    public void previews(List<PortalPreview> now) {
        previews = now;
    }

    /** Returns the portals that are closing. */
    public List<ClosingPortal> closing() {
        return closing;
    }

    public void closing(List<ClosingPortal> now) {
        closing = now;
    }

    /** Returns the lights of the last shots. */
    public List<ShotEffect> shotEffects() {
        return shotEffects;
    }

    public void shotEffects(List<ShotEffect> now) {
        shotEffects = now;
    }

    /** Returns the light of the last shot on the surfaces around; {@code null} if there is none. */
    public MuzzleLight muzzleLight() {
        return muzzleLight;
    }

    public void muzzleLight(MuzzleLight now) {
        muzzleLight = now;
    }

    /** Returns the gun in the hand of the player whose eye is the main view's; {@code null} if none is drawn. */
    public GunInHand gun() {
        return gun;
    }

    public void gun(GunInHand now) {
        gun = now;
    }

    /**
     * The observer's sphere.
     *
     * @param centre metres, which billboards face
     * @param touches whether it has the colour of a contact
     */
    public record ObserverSphere(Vec3 centre, double radiusMetres, boolean touches) {}

    /**
     * The position and the animation state of a character.
     *
     * @param centre centre of its body, on the near side of every portal
     * @param up from feet to head, unit length
     * @param yawRadians view angle as in {@code math.Basis.ofYawPitch}; {@code pitchRadians} likewise
     * @param heightMetres present height from sole to crown
     * @param step phase of the walking cycle, 0 to 1 for a left and a right step; it advances by
     *     {@link nephele.engine.scene.dynamic.Gait#cyclesPerSecond} a second, so that the feet do not slide
     * @param stride ground speed divided by {@link nephele.engine.scene.dynamic.Gait#WALKING_METRES_PER_SECOND}: 0
     *     standing
     * @param travelRadians walking direction relative to the view direction: 0 ahead, positive to the left, π backwards
     * @param airborne 0 on the ground, 1 in the air
     * @param carrying 0 with free hands, 1 while carrying a body in front
     */
    public record Posture(
            Vec3 centre,
            Vec3 up,
            double yawRadians,
            double pitchRadians,
            double heightMetres,
            double step,
            double stride,
            double travelRadians,
            double airborne,
            double carrying) {
        /** Returns the same posture at another place. */
        public Posture at(Vec3 other) {
            return new Posture(
                    other, up, yawRadians, pitchRadians, heightMetres, step, stride, travelRadians, airborne, carrying);
        }

        /** Returns the same posture mapped by a portal transform. */
        public Posture through(PortalTransform transform) {
            Vec3 turned = transform.direction(up);
            Vector3d back = Basis.ofYawPitch(yawRadians, 0).back().toVector();
            transform.direction(leaning(up).transform(back));
            leaning(turned).transformInverse(back);
            return new Posture(
                    transform.point(centre),
                    turned,
                    Math.atan2(back.x, back.z),
                    pitchRadians,
                    heightMetres,
                    step,
                    stride,
                    travelRadians,
                    airborne,
                    carrying);
        }

        /** Returns the shortest rotation that maps the world's up direction to {@code up}. */
        public static Quaterniond leaning(Vec3 up) {
            return Rotations.normalised(new Quaterniond().rotationTo(0, 1, 0, up.x(), up.y(), up.z()));
        }
    }

    /**
     * A portal that a shot has taken away, while its rim closes.
     *
     * @param colour 0 or 1, the number of the shot
     * @param openness 1 when it begins, 0 when it has closed
     */
    public record ClosingPortal(Portal portal, int colour, double openness) {}

    /**
     * The preview of the portal that a shot would open.
     *
     * @param colour 0 or 1, the number of the shot
     */
    public record PortalPreview(Portal portal, int colour) {}

    /**
     * The short light of a shot; a value of the frame state.
     *
     * @param kind what is drawn
     * @param colour 0 or 1, the number of the shot
     * @param age fraction of its duration that has passed, 0 to 1
     * @param from where a bolt begins, metres; the place of a shimmer
     * @param to where a bolt ends; of a shimmer a metre from its place along the surface's normal
     */
    public record ShotEffect(Kind kind, int colour, double age, Vec3 from, Vec3 to) {
        /** The fraction of its duration in which a bolt's head reaches its end. */
        public static final double BOLT_FLIGHT = 0.45;

        /** The length of a bolt's tail in flight, as a fraction of the path. */
        public static final double BOLT_TAIL = 0.55;

        /** The effects. */
        public enum Kind {
            /** A streak from the gun to the surface. */
            BOLT,
            /** Rings on a surface that takes no portal. */
            SHIMMER
        }
    }
}
