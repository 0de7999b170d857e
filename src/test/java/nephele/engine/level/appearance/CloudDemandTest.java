package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Many clouds share the cells of a few. */
class CloudDemandTest {
    private static Cloud small(int index) {
        return new Cloud(
                "c" + index,
                new Cloud.Extent.Volume(new Vec3(4 * index, 5, 0), new Vec3(3, 3, 3)),
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                0.5,
                1,
                0,
                Cloud.Motion.STILL);
    }

    private static CloudDemand demand(int clouds) {
        return CloudDemand.of(
                IntStream.range(0, clouds).mapToObj(CloudDemandTest::small).toList());
    }

    @Test
    void aFewCloudsHaveAllTheirCells() {
        assertEquals(96, demand(9).longest());
        assertEquals(1, demand(9).fraction());
    }

    @Test
    void manyCloudsShareTheirCellsAndAreStillDivided() {
        for (int clouds : List.of(101, 1000)) {
            CloudDemand demand = demand(clouds);
            assertTrue(demand.cells() <= CloudDemand.MOST_CELLS, demand.cells() + " cells of " + clouds);
            assertTrue(demand.longest() >= 12, clouds + " clouds have " + demand.longest() + " cells to an edge");
            assertTrue(demand.bytes() < 350e6, "bytes " + demand.bytes());
        }
        assertTrue(demand(1000).seconds() < 30, "seconds " + demand(1000).seconds());
    }

    /** Memory is asked for before it is taken, never found missing in the middle. */
    @Test
    void cloudsForWhichMemoryDoesNotSufficeAreRefusedWithAnEstimate() {
        demand(4).requireMemory(150_000_000);
        CloudDemand many = demand(1000);
        AssetException refused = assertThrows(AssetException.class, () -> many.requireMemory(150_000_000));
        assertEquals(
                "environment.clouds: 1000 clouds need some 16 s of a processor's time and 164 MB of memory, more than"
                    + " the 150 MB that Java may take; use fewer layers and fewer seeds of noise, or give Java more,"
                    + " for example `java -Xmx4g -jar …`",
                refused.getMessage());
        many.requireMemoryOfTables(150_000_000);
    }
}
