package nephele.engine.cloud.drawn;

import nephele.engine.cloud.cells.DensityCells;
import nephele.engine.cloud.field.NoiseField;
import nephele.engine.cloud.field.ProfiledNoise;

/** The columns of a noise with a profile, in the places of its field. */
final class NoiseColumns implements DensityCells.Columns {
    private final NoiseField field;
    private final ProfiledNoise noise;

    NoiseColumns(NoiseField field) {
        this.field = field;
        noise = (ProfiledNoise) field.density();
    }

    @Override
    public double depth(double x, double z) {
        return noise.bodyDepth(x - field.origin().x(), z - field.origin().z());
    }

    @Override
    public double greatestDepth(double x, double z, double halfX, double halfZ) {
        return noise.greatestBodyDepth(
                x - field.origin().x(), z - field.origin().z(), halfX, halfZ);
    }

    @Override
    public double leastDepth(double fromY, double toY) {
        return noise.leastDepth(fromY - field.origin().y(), toY - field.origin().y());
    }

    @Override
    public double perMetre(double depth, double x, double y, double z) {
        return field.extinctionPerMetre()
                * noise.at(
                        depth,
                        x - field.origin().x(),
                        y - field.origin().y(),
                        z - field.origin().z());
    }
}
