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
            new Trade.Text(
                    "Sun shadow",
                    "The sun's shadows come from a depth map of this many texels along its longer side, but of no finer"
                            + " texels than 1 cm. Off means that neither sun nor punctual lights cast any.",
                    "the oracle: every shadow is a ray"),
            List.of(FIELD),
            "4096",
            Stream.concat(
                            Stream.of(new PictureSetting(
                                    new Setting("off", "no shadows at all"),
                                    shot -> shot.with(unshadowed(shot.level())))),
                            Stream.of(256, 512, 1024, 2048, 4096, 8192)
                                    .map(texels -> PictureSetting.of(FIELD, texels, note(texels))))
                    .toList());

    private ShadowSubject() {}

    private static String note(int texels) {
        return switch (texels) {
            case 2048 -> "low";
            case 4096 -> "medium, high and ultra";
            default -> "";
        };
    }

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
