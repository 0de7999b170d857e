package nephele.host.playthrough;

import java.util.List;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.placed.ModelBounds;
import nephele.engine.level.placed.PlacedModels;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.scene.FrameState.ObserverSphere;
import nephele.engine.scene.View;
import nephele.engine.sim.player.PlayerPose;
import nephele.engine.sim.state.PlayerState;

/**
 * The picture of a level with an observer: its fixed camera, its sphere, which stands where the player's feet are, and
 * the bounds of models that the sphere touches. The simulation does not know the sphere: it moves the player's body.
 */
public final class ObserverView {
    private final Level.Observer authored;
    private final Camera camera;
    private final ModelBounds bounds;
    private Bound touchable;
    private View view;

    private ObserverView(Level level, PlacedModels models) {
        authored = level.observer();
        camera = level.cameras().stream()
                .filter(one -> authored.camera() == null || authored.camera().equals(one.id()))
                .findFirst()
                .orElseThrow();
        bounds = ModelBounds.of(models);
        touchable = authored.bounds();
    }

    /** Returns the view of a level; {@code null} if it has no observer. */
    public static ObserverView of(Level level, PlacedModels models) {
        return level.observer() == null ? null : new ObserverView(level, models);
    }

    /** Goes to the next kind of bounds. */
    public void nextBounds() {
        touchable = Bound.values()[(touchable.ordinal() + 1) % Bound.values().length];
    }

    /** Returns the kind of bounds that the sphere touches. */
    public Bound touchable() {
        return touchable;
    }

    /** Returns the lines that show the bounds: pairs of points in the world. */
    public List<Vec3> outlines() {
        return bounds.outlines(touchable);
    }

    View view(double aspect) {
        if (view == null || view.projection().aspect() != aspect) {
            view = View.ofCamera(camera, 0, aspect);
        }
        return view;
    }

    /** Returns the sphere at a pose of the player between two ticks. */
    ObserverSphere sphere(PlayerPose.Body body, PlayerState player) {
        double above = authored.radiusMetres() - player.stance().centreAboveFeet();
        return at(body.centre().addScaled(above, body.up()));
    }

    /** Returns the sphere with its centre at a place. */
    public ObserverSphere at(Vec3 centre) {
        return new ObserverSphere(
                centre, authored.radiusMetres(), bounds.touch(touchable, centre, authored.radiusMetres()));
    }
}
