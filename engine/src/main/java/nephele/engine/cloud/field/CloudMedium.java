package nephele.engine.cloud.field;

import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.PhaseFunction;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Cloud;

/**
 * A scattering medium.
 *
 * @param albedo scattering divided by extinction, 0 to 1
 */
public record CloudMedium(ExtinctionField field, double albedo, PhaseFunction phase) {
    public CloudMedium {
        if (!(albedo >= 0 && albedo <= 1)) {
            throw new IllegalArgumentException("albedo " + albedo + " is not in 0 to 1");
        }
    }

    /** Returns the medium of a cloud of a level with its field at some time. */
    static CloudMedium of(Cloud cloud, ExtinctionField field) {
        return new CloudMedium(field, cloud.albedo(), CloudOptics.of(cloud));
    }
}
