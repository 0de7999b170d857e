package nephele.lab.bake;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.reference.Pinhole;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.reference.sky.SunDisc;
import nephele.engine.reference.tile.PartHeader;
import nephele.engine.reference.tile.Shard;
import nephele.engine.reference.tile.TiledPicture;
import nephele.host.named.OpenedLevel;

/**
 * Traces what an eye sees of a level's sky, clouds included, in all directions: the level without anything else, and
 * without fog, which the level that uses the pictures still has.
 */
public final class SkyboxTrace {
    private static final long SEED = 1;

    /** The fraction of the sun's light is then known to 0.2 per cent, whatever the clouds are. */
    private static final int SUN_ESTIMATES = 100_000;

    /** The fraction of a star's light is then known to 1.6 per cent. */
    private static final int STAR_ESTIMATES = 1_000;

    private final OpenedLevel opened;
    private final Environment lit;
    private final TracedLevel sky;
    private final Vec3 eye;

    /** @throws nephele.host.terminal.CommandFailure that names an asset that is missing or cannot be used */
    public SkyboxTrace(OpenedLevel opened, Vec3 eye) {
        this.opened = opened;
        this.eye = eye;
        lit = Daylight.lit(opened.level()).environment();
        // No surface needs the sky's irradiance, which is integrated unless the ambient light is a constant.
        Level alone = Level.of("", "", lit.withFog((Environment.Fog) null).withAmbient(Vec3.ZERO), List.of());
        sky = opened.reporting(() -> TracedLevel.of(PlacedLevel.of(alone, opened.assets()), ColourDecoding.SRGB));
    }

    public boolean hasClouds() {
        return sky.hasClouds();
    }

    /**
     * Traces the six pictures; an interrupted run goes on when it is started again.
     *
     * @param side of a picture, pixels
     * @param log receives progress
     */
    public BakedSkybox run(List<ResumableTrace.Part> parts, TraceSettings settings, PrintStream log)
            throws IOException {
        List<TiledPicture> pictures = new ResumableTrace(parts, log).run(sky, settings);
        Sun onGround = Daylight.onGround(lit);
        double fraction = onGround == null
                ? 1
                : sky.shareThroughClouds(eye, Directions.unit(onGround.directionTowardsSun()), SUN_ESTIMATES, SEED);
        var baked = new BakedSkybox(
                settings.width(), pictures.stream().map(TiledPicture::rgb).toList(), fraction);
        if (lit.sky() instanceof Sky.Atmosphere atmosphere) {
            SunDisc.of(lit).ifPresent(sun -> baked.add(sun, eye.y(), fraction));
            NightSky.of(atmosphere, lit.sun(), eye.y())
                    .ifPresent(night ->
                            baked.add(night, towards -> sky.shareThroughClouds(eye, towards, STAR_ESTIMATES, SEED)));
        }
        return baked;
    }

    /** Returns the six pictures that are to be traced. */
    public List<ResumableTrace.Part> parts(TraceSettings settings, Path folder, String name) {
        List<SkyboxSquare> squares = SkyboxSquare.of(SkyboxLayout.FACES);
        return IntStream.range(0, squares.size())
                .mapToObj(i -> {
                    var pinhole = new Pinhole(eye, squares.get(i).basis(), 1, 1, 0, Double.POSITIVE_INFINITY);
                    return new ResumableTrace.Part(
                            folder.resolve(BakedSkybox.file(name, i) + ".part"),
                            new PartHeader(
                                    settings.tiles(),
                                    Shard.WHOLE,
                                    TracedPictures.facts(opened, 0, pinhole, settings, "sky")),
                            pinhole);
                })
                .toList();
    }

    /** Returns the settings of pictures of a size. */
    public static TraceSettings settings(int side, int samples) {
        return new TraceSettings(side, side, samples, SEED, Runtime.getRuntime().availableProcessors());
    }
}
