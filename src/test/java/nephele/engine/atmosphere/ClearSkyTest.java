package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The sun of the tables is a point, whose shadow has a hard edge. */
@Execution(ExecutionMode.CONCURRENT)
class ClearSkyTest {
    @Test
    void everyRowOfTheMonteCarloTableIsMetWithinFourSigmaAndOnePercent() {
        List<AtmosphereRow> rows = AtmosphereRow.read("atmosphere.csv");
        assertEquals(460, rows.size());
        ClearSky sky = new ClearSky(AirTables.of(Air.CLEAR.withSunRadius(0)));
        AirRay ray = new AirRay();
        for (AtmosphereRow row : rows) {
            row.aim(ray);
            Vec3 computed = sky.radiance(ray);
            assertTrue(row.isMetBy(computed, 0.01, 0), row.text() + ": " + computed);
        }
    }
}
