package nephele.lab.bake;

import nephele.engine.math.Basis;
import nephele.engine.reference.Pinhole;
import nephele.engine.scene.View;

/** Converts a view of the engine to the oracle's pinhole camera. */
public final class PinholeViews {
    private PinholeViews() {}

    public static Pinhole of(View view) {
        var projection = view.projection();
        return new Pinhole(
                view.eye(),
                new Basis(view.right(), view.up(), view.back()),
                projection.tanHalfWidth(),
                projection.tanHalfHeight(),
                projection.nearMetres(),
                projection.farMetres());
    }
}
