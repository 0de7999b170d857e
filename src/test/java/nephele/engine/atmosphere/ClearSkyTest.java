package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class ClearSkyTest {
    @Test
    void everyRowOfTheMonteCarloTableIsMetWithinFourSigmaAndOnePercent() {
        List<AtmosphereRow> rows = AtmosphereRow.read("atmosphere.csv");
        assertEquals(460, rows.size());
        long t0 = System.nanoTime();
        ClearSky sky = new ClearSky(Air.CLEAR);
        System.out.println("built in " + (System.nanoTime() - t0) / 1e9);
        AirRay ray = new AirRay();
        List<String> wrong = new ArrayList<>();
        for (AtmosphereRow row : rows) {
            row.aim(ray);
            Vec3 computed = sky.radiance(ray);
            double[] rgb = {computed.x(), computed.y(), computed.z()};
            for (int c = 0; c < 3; c++) {
                double error = Math.abs(rgb[c] - row.radiance()[c]);
                System.out.printf(
                        "ROW %.3f %.3f %s %d%n",
                        100 * (rgb[c] / row.radiance()[c] - 1),
                        100 * row.standardError()[c] / row.radiance()[c],
                        row.text(),
                        c);
                if (error > 4 * row.standardError()[c] + 0.01 * row.radiance()[c]) {
                    wrong.add(row.text() + " channel " + c + ": " + rgb[c]);
                }
            }
        }
        System.out.println("rows in " + (System.nanoTime() - t0) / 1e9);
        assertEquals(List.of(), wrong);
    }
}
