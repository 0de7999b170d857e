package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class SingleScatteringTest {
    @Test
    void lightScatteredOnceIsThatOfTheQuadratureInTheTableWithinTwoThousandths() {
        List<AtmosphereRow> rows = AtmosphereRow.read("atmosphere_single.csv");
        assertEquals(40, rows.size());
        Air air = Air.CLEAR;
        SingleScattering source = new SingleScattering(air, new Sunlight(new SunTransmittance(air), 0));
        AirIntegral integral = new AirIntegral(air, AirIntegral.FINE);
        AirRay ray = new AirRay();
        double[] radiance = new double[6];
        double worst = 0;
        for (AtmosphereRow row : rows) {
            row.aim(ray);
            integral.put(ray, source, radiance, new double[3]);
            for (int c = 0; c < 3; c++) {
                double computed = Air.rayleighPhase(ray.betweenCosine()) * radiance[c]
                        + air.miePhase(ray.betweenCosine()) * radiance[3 + c];
                double error = Math.abs(computed / row.radiance()[c] - 1);
                if (row.radiance()[c] == 0) {
                    error = computed;
                }
                worst = Math.max(worst, error);
            }
        }
        assertTrue(worst < 0.002, "relative error " + worst);
    }
}
