package nephele.scenes.view;

import java.util.EnumSet;
import java.util.Set;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.scenes.fixed.LightTerm;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.fixed.Shading;
import nephele.scenes.xml.XmlScene;

/**
 * The state of the viewer: camera and entity, appearance and the scene's clock. It reads no clock of its own: the same
 * keys at the same times give the same pictures.
 */
public final class ViewerState {
    static final double UNITS_PER_SECOND = 6;
    /** The speed factor of the key {@link ViewerKey#FASTER}. */
    static final double FASTER = 4;

    static final double DEGREES_PER_PRESS = 5;
    static final double DEGREES_PER_PIXEL = 0.5;

    private final XmlScene.Eye eye;
    private final ThirdPersonCamera home;
    private ThirdPersonCamera place;
    private SceneAppearance look;
    private Shading filled;
    private double sceneSeconds;
    private boolean paused;

    private ViewerState(XmlScene.Eye eye, ThirdPersonCamera home, SceneAppearance look, double sceneSeconds) {
        this.eye = eye;
        this.home = home;
        this.look = look;
        this.sceneSeconds = sceneSeconds;
        place = home;
        filled = look.shading() == Shading.WIREFRAME ? Shading.GOURAUD : look.shading();
    }

    /** Creates a viewer with an entity before the eye. */
    public static ViewerState towing(XmlScene.Eye eye, SceneAppearance look, double sceneSeconds) {
        return new ViewerState(eye, ThirdPersonCamera.towing(eye.position(), heading(eye)), look, sceneSeconds);
    }

    /** Creates a viewer without an entity. */
    public static ViewerState alone(XmlScene.Eye eye, SceneAppearance look, double sceneSeconds) {
        return new ViewerState(eye, ThirdPersonCamera.alone(eye.position(), heading(eye)), look, sceneSeconds);
    }

    private static ViewerAngles heading(XmlScene.Eye eye) {
        return ViewerAngles.between(eye.position(), eye.lookAt(), eye.up());
    }

    /** Advances the time while keys are held. */
    public void advance(double seconds, Set<ViewerKey> held) {
        place = place.after(seconds, steering(held));
        boolean passes = seconds > 0 && seconds < Double.POSITIVE_INFINITY && !paused;
        sceneSeconds += passes ? seconds : 0;
    }

    private static Steering steering(Set<ViewerKey> held) {
        return new Steering(
                axis(held, ViewerKey.RIGHT, ViewerKey.LEFT),
                axis(held, ViewerKey.AHEAD, ViewerKey.BACK),
                held.contains(ViewerKey.FASTER) ? FASTER * UNITS_PER_SECOND : UNITS_PER_SECOND);
    }

    private static int axis(Set<ViewerKey> held, ViewerKey positive, ViewerKey negative) {
        return (held.contains(positive) ? 1 : 0) - (held.contains(negative) ? 1 : 0);
    }

    /** Turns the view by a pointer drag. */
    public void drag(double pixelsRight, double pixelsDown) {
        place = place.turned(-DEGREES_PER_PIXEL * pixelsRight, -DEGREES_PER_PIXEL * pixelsDown);
    }

    /** Handles a key that went down. */
    public void press(ViewerKey key) {
        switch (key) {
            case TURN_LEFT -> place = place.turned(DEGREES_PER_PRESS, 0);
            case TURN_RIGHT -> place = place.turned(-DEGREES_PER_PRESS, 0);
            case LOOK_UP -> place = place.turned(0, DEGREES_PER_PRESS);
            case LOOK_DOWN -> place = place.turned(0, -DEGREES_PER_PRESS);
            case HOME -> place = home;
            case PAUSE -> paused = !paused;
            case AXES -> look = look.withAxes(!look.axes());
            case WIREFRAME -> look = look.with(isWireframe() ? filled : Shading.WIREFRAME);
            case SHADING -> nextShading();
            case AMBIENT, DIFFUSE, SPECULAR, EMISSIVE -> toggle(key.term());
            default -> {}
        }
    }

    private boolean isWireframe() {
        return look.shading() == Shading.WIREFRAME;
    }

    private void nextShading() {
        if (!isWireframe()) {
            filled = switch (filled) {
                case FLAT -> Shading.GOURAUD;
                case GOURAUD -> Shading.PHONG;
                case PHONG, WIREFRAME -> Shading.FLAT;
            };
        }
        look = look.with(filled);
    }

    private void toggle(LightTerm term) {
        var terms = EnumSet.noneOf(LightTerm.class);
        terms.addAll(look.terms());
        if (!terms.remove(term)) {
            terms.add(term);
        }
        look = look.with(terms);
    }

    /** Returns true while the scene's clock rests. */
    public boolean isPaused() {
        return paused;
    }

    /** Returns where the camera and the entity are. */
    public ThirdPersonCamera place() {
        return place;
    }

    /** Returns how the scene is drawn. */
    public SceneAppearance look() {
        return look;
    }

    /** Returns the scene's clock. */
    public double sceneSeconds() {
        return sceneSeconds;
    }

    /**
     * Returns the view. The vertical field of view is the scene's, whatever the picture's width.
     *
     * @param aspect width / height
     */
    public View view(double aspect) {
        var basis = place.heading().basis();
        var projection = new Projection(StrictMath.toRadians(eye.fovDegrees()), aspect, eye.near(), eye.far());
        return new View(place.eye(), basis.right(), basis.up(), basis.back(), projection);
    }
}
