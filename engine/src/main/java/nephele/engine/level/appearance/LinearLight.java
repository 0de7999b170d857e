package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;

/**
 * Decides whether a level's light is accumulated in a linear target before tone mapping, because a pass adds light to
 * the drawn surfaces, or because exposure is metered from the picture.
 */
public final class LinearLight {
    private LinearLight() {}

    /** Returns the reason; empty if there is none. */
    public static Optional<String> because(Level level) {
        if (level.environment().exposureStops().isAuto()) {
            return Optional.of("environment.exposureStops: auto meters linear light");
        }
        if (!WeatherClouds.all(level.environment()).isEmpty()) {
            return Optional.of("environment.clouds: they are blended with what is behind them");
        }
        if (level.environment().hasLightning()) {
            return Optional.of("environment.lightning: it adds light to what is behind");
        }
        if (level.emitters().stream().anyMatch(emitter -> emitter.ratePerSecond() > 0)) {
            return Optional.of("emitters: particles are blended with what is behind them");
        }
        if (level.billboards().stream().anyMatch(Billboards::blended)) {
            return Optional.of("billboards: some are blended with what is behind them");
        }
        int tinted = MirrorFaces.firstTinted(level);
        return tinted < 0 || FogTransmittance.of(level.environment()).isEmpty()
                ? Optional.empty()
                : Optional.of("materials[" + tinted + "].mirror: fog before it is added to what it tints");
    }
}
