package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.cells.LightCells;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.Environment;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;

/** Rays through the middles of a picture's pixels, marched by the Java twin of the shader and integrated exactly. */
final class CloudRays implements AutoCloseable {
    private static final OutsideOfCloud DARK = new OutsideOfCloud(new Vec3(0, 1, 0), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    /** How far rays are followed, metres. */
    private static final double FAR = 200_000;

    private static final int WIDTH = 160;
    /** Where the clouds' shade on surfaces is computed, which no ray needs. */
    private static final Vec3 REGION = new Vec3(1, 1, 1);

    private final View view;
    private final int height;
    private final CloudTimeline timeline;
    private final List<DrawnCloud> clouds;
    private final double[] exact;
    private double evaluations;
    private double transmittanceError;

    CloudRays(PlacedLevel placed, View view) {
        this.view = view;
        height = (int) Math.round(WIDTH / view.projection().aspect());
        Environment environment = placed.level().environment();
        timeline = new CloudTimeline(environment, placed.assets(), Aabb.around(view.eye(), REGION), LightCells.DIVISOR);
        clouds = timeline.at(environment, 0, view.eye()).from().clouds();
        List<CloudMedium> media = LoadedClouds.of(environment, placed.assets()).at(0);
        exact = new double[WIDTH * height];
        for (int pixel = 0; pixel < exact.length; pixel++) {
            double depth = 0;
            for (CloudMedium medium : media) {
                depth += OpticalDepth.quadrature(medium.field(), ray(pixel), 0, FAR, 1);
            }
            exact[pixel] = Math.exp(-depth);
        }
    }

    /** Marches all rays with a step; the figures are those of the last march. */
    void march(double stepCells) {
        List<CellMarch> marches = new ArrayList<>();
        for (DrawnCloud cloud : clouds) {
            marches.add(new CellMarch(
                    cloud.cells(),
                    DARK,
                    view.eye(),
                    cloud.source().isProfiled() ? cloud.source().noise(0) : null));
        }
        double fetches = 0;
        double squares = 0;
        for (int pixel = 0; pixel < exact.length; pixel++) {
            double left = 1;
            for (CellMarch march : marches) {
                march.march(ray(pixel), 0, FAR, stepCells, offset(pixel));
                left *= march.transmittance();
                fetches += march.fetches();
            }
            squares += (left - exact[pixel]) * (left - exact[pixel]);
        }
        evaluations = fetches / exact.length;
        transmittanceError = Math.sqrt(squares / exact.length);
    }

    /** Returns the evaluations of the density, a ray; the shader leaps over empty cells and makes fewer. */
    double evaluations() {
        return evaluations;
    }

    /** Returns the root mean square, over all rays. */
    double transmittanceError() {
        return transmittanceError;
    }

    /** As the shader spreads the first samples of rays. */
    private static double offset(int pixel) {
        double spread = (pixel % WIDTH + 0.5) * 0.06711056 + (pixel / WIDTH + 0.5) * 0.00583715;
        double wide = 52.9829189 * (spread - Math.floor(spread));
        return wide - Math.floor(wide);
    }

    private Ray ray(int pixel) {
        double x = (2 * (pixel % WIDTH) + 1.0) / WIDTH - 1;
        double y = (2 * (pixel / WIDTH) + 1.0) / height - 1;
        Vec3 along = view.back()
                .negated()
                .addScaled(x * view.projection().tanHalfWidth(), view.right())
                .addScaled(y * view.projection().tanHalfHeight(), view.up());
        return Ray.of(view.eye(), along.scaled(1 / along.length()));
    }

    @Override
    public void close() {
        timeline.close();
    }
}
