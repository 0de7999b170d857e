package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelSaveException;
import nephele.engine.math.Vec3;
import nephele.engine.named.AssetProblems;
import nephele.engine.named.LevelName;
import nephele.engine.named.OpenedLevel;
import nephele.engine.render.Capture;
import nephele.engine.terminal.CommandFailure;
import nephele.engine.terminal.ExitCode;
import nephele.engine.terminal.PrintedProgress;
import nephele.engine.terminal.Terminal;
import nephele.lab.art.BakedSkybox;
import nephele.lab.art.SkyVisibilityBaker;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Bakes a level's sky into the six pictures of a skybox, or the light that a level caches into files beside it. */
@picocli.CommandLine.Command
final class BakeCommand implements Command {
    private static final int MOST_SIDE = 4096;
    private static final int MOST_SAMPLES = 4096;

    @Parameters(arity = "1", paramLabel = "LEVEL", description = "A level file.")
    private String level;

    @Option(
            names = "--sky",
            paramLabel = "NAME",
            description = "Write NAME-px.png … NAME-nz.png and NAME.json, the level that uses them, beside the level.")
    private String sky;

    @Option(
            names = "--eye",
            paramLabel = "x,y,z",
            converter = NumberList.PointConverter.class,
            description = "The place that sees the sky (default: the player's start, else the origin).")
    private Vec3 eye;

    @Option(
            names = "--face-size",
            paramLabel = "N",
            defaultValue = "512",
            description = "Pixels along a side of a picture (default: 512).")
    private int side;

    @Option(names = "--spp", paramLabel = "N", defaultValue = "4", description = "Samples a pixel (default: 4).")
    private int samples;

    @Option(
            names = "--light",
            description = "Write the sky visibility of the level's surfaces into the folder baked beside it.")
    private boolean isLight;

    @Override
    public ExitCode run(Terminal terminal) {
        checkUsage();
        OpenedLevel opened = new LevelName(level).open();
        opened.notice().ifPresent(terminal.err()::println);
        Path file = Path.of(opened.file()).toAbsolutePath();
        if (isLight) {
            bakeLight(file, terminal);
        }
        if (sky != null) {
            bakeSky(opened, file.getParent(), terminal);
        }
        return ExitCode.DONE;
    }

    private void checkUsage() {
        if (sky == null && !isLight) {
            throw CommandFailure.usage("say what to bake: --sky NAME, --light or both");
        }
        if (sky != null && !sky.matches("[A-Za-z0-9._-]{1,100}")) {
            throw CommandFailure.usage("--sky is a name of letters, digits, '.', '_' and '-', not '" + sky + "'");
        }
        if (side < 1 || side > MOST_SIDE) {
            throw CommandFailure.usage("--face-size is a whole number from 1 to " + MOST_SIDE + ", not " + side);
        }
        if (samples < 1 || samples > MOST_SAMPLES) {
            throw CommandFailure.usage("--spp is a whole number from 1 to " + MOST_SAMPLES + ", not " + samples);
        }
    }

    private static void bakeLight(Path file, Terminal terminal) {
        try {
            SkyVisibilityBaker.bake(file, PrintedProgress.ofBake(terminal.err()))
                    .forEach(terminal.out()::println);
        } catch (IOException failure) {
            throw CommandFailure.environment(
                    file + ": its light can't be written beside it: " + AtomicFile.reason(failure), failure);
        }
    }

    private void bakeSky(OpenedLevel opened, Path folder, Terminal terminal) {
        Level lit = Daylight.lit(opened.level());
        SkyRadiance radiance = AssetProblems.named(opened, () -> SkyRadiance.of(
                        lit.environment(),
                        id -> PictureDecoder.decode(id, opened.assets().bytes(id)),
                        ColourDecoding.SRGB)
                .orElseThrow(() -> CommandFailure.input(
                        opened.file() + ": environment.sky: there is no sky to bake; give it one")));
        Path target = folder.resolve(sky + ".json");
        if (target.equals(Path.of(opened.file()).toAbsolutePath())) {
            throw CommandFailure.usage("--sky " + sky + " would replace the level itself; choose another name");
        }
        BakedSkybox faces = new BakedSkybox(radiance, eye == null ? start(lit) : eye, side, samples);
        faces.trace(PrintedProgress.ofTrace(terminal.err()));
        for (int face = 0; face < BakedSkybox.NAMES.size(); face++) {
            int index = face;
            WrittenFile.write(
                    folder.resolve(sky + "-" + BakedSkybox.NAMES.get(face) + ".png"),
                    to -> Capture.png(faces.picture(index), to));
        }
        try {
            LevelFile.save(target, faces.usedBy(lit, sky));
        } catch (LevelSaveException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
        terminal.out().println(target + " and six pictures of " + side + " pixels");
        terminal.out()
                .println(String.format(
                        Locale.ROOT,
                        "8 bits clip %.2f %% of the sky's pixels at 1 (the brightest has %.3g); %.2f %% are darker than"
                                + " the first code",
                        100 * faces.clippedShare(),
                        faces.brightest(),
                        100 * faces.darkShare()));
    }

    private static Vec3 start(Level level) {
        return level.player() == null ? Vec3.ZERO : level.player().feet();
    }
}
