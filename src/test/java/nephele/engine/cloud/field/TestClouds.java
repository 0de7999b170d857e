package nephele.engine.cloud.field;

import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.noise.CloudTables;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;

/** Fields of clouds that share one set of tables, which are slow to make; a seed still chooses the places in them. */
final class TestClouds {
    private static final CloudTables TABLES = CloudTables.of(7);

    private TestClouds() {}

    static ExtinctionField field(Cloud.Extent extent, Cloud.Density density, double extinctionPerMetre) {
        return field(extent, density, extinctionPerMetre, Cloud.Motion.STILL, 0);
    }

    static ExtinctionField field(
            Cloud.Extent extent,
            Cloud.Density density,
            double extinctionPerMetre,
            Cloud.Motion motion,
            double seconds) {
        return fields(cloud(extent, density, extinctionPerMetre, motion)).flat(seconds, 0);
    }

    /** Returns the field of a layer to be bent into a shell. */
    static ExtinctionField slack(Cloud.Extent extent, Cloud.Density density, double extinctionPerMetre) {
        Cloud cloud = cloud(extent, density, extinctionPerMetre, Cloud.Motion.STILL);
        return fields(cloud).flat(0, ShellField.SLACK_METRES);
    }

    private static Cloud cloud(Cloud.Extent extent, Cloud.Density density, double extinction, Cloud.Motion motion) {
        return new Cloud("c", extent, CloudTechnique.AUTO, density, extinction, 1, 0, motion);
    }

    private static CloudFields fields(Cloud cloud) {
        return CloudFields.of(cloud, TestPictures.COVERAGE, seed -> TABLES);
    }
}
