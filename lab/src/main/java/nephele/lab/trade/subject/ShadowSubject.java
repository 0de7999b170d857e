package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sun;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** Quality field {@code shadowTexels}, and shadows switched off. */
public final class ShadowSubject {
    private static final String FIELD = "shadowTexels";

    public static final Trade TRADE = PictureSubjects.of(
            "shadow",
            PictureSubjects.text(FIELD, "the oracle: every shadow is a ray"),
            List.of(FIELD),
            PictureSubjects.usual(FIELD),
            Stream.concat(
                            Stream.of(new PictureSetting(
                                    new Setting("off", "no shadows at all"),
                                    shot -> shot.with(unshadowed(shot.level())))),
                            PictureSetting.all(FIELD, 256, 512, 1024, 2048, 4096, 8192).stream())
                    .toList());

    private ShadowSubject() {}

    private static Level unshadowed(Level level) {
        var light = level.environment();
        Sun sun = light.sun() == null
                ? null
                : new Sun(light.sun().directionTowardsSun(), light.sun().irradiance(), false);
        var environment = light.with(sun);
        return level.with(
                environment,
                level.lights().stream().map(ShadowSubject::unshadowed).toList());
    }

    private static Light unshadowed(Light light) {
        if (light instanceof Light.Spot spot) {
            return new Light.Spot(
                    spot.id(),
                    spot.position(),
                    spot.direction(),
                    spot.radiantIntensity(),
                    spot.rangeMetres(),
                    spot.innerConeDegrees(),
                    spot.outerConeDegrees(),
                    false);
        }
        return new Light.Point(light.id(), light.position(), light.radiantIntensity(), light.rangeMetres(), false);
    }
}
