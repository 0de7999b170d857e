package nephele.app.command;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import nephele.engine.bake.LightBake;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelSaveException;
import nephele.engine.math.Vec3;
import nephele.engine.reference.TraceSettings;
import nephele.engine.render.Capture;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.lab.bake.BakedSkybox;
import nephele.lab.bake.LightBaker;
import nephele.lab.bake.ResumableTrace;
import nephele.lab.bake.SkyboxTrace;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Bakes a level's sky into the six pictures of a skybox, or the light that a level caches into files beside it. */
@picocli.CommandLine.Command
final class BakeCommand implements Command {
    private static final int MOST_SIDE = 4096;
    private static final int MOST_SAMPLES = 4096;
    private static final int USUAL_SAMPLES = 4;
    private static final int USUAL_CLOUDED_SAMPLES = 64;

    @Parameters(arity = "1..*", paramLabel = "LEVEL", description = "A level file; several only with --light.")
    private List<String> levels;

    @Option(
            names = "--sky",
            paramLabel = "NAME",
            description = "Write NAME-px.png … NAME-nz.png and NAME.json, the level that uses them, beside the level.")
    private String sky;

    @Option(
            names = "--eye",
            paramLabel = "x,y,z",
            description = "The place that sees the sky (default: the player's start, else the origin).")
    private Vec3 eye;

    @Option(
            names = "--face-size",
            paramLabel = "N",
            defaultValue = "512",
            description = "Pixels along a side of a picture (default: 512).")
    @OptionRange.Whole(least = 1, most = MOST_SIDE)
    private int side;

    @Option(
            names = "--spp",
            paramLabel = "N",
            description =
                    "Samples a pixel (default: 4, with clouds 64). An interrupted bake goes on when the same command"
                            + " is typed again.")
    @OptionRange.Whole(least = 1, most = MOST_SAMPLES)
    private Integer samples;

    @Option(
            names = "--light",
            description = "Write the light of the level's surfaces into the folder baked beside it. An interrupted bake"
                    + " goes on when the same command is typed again.")
    private boolean isLight;

    @Option(
            names = "--light-error",
            paramLabel = "PERCENT",
            description =
                    "Standard error at which a point of a surface is done, of its light (usually 3); bakes again.")
    @OptionRange.Decimal(least = 0.1, most = 50, unit = "percent")
    private Double lightError;

    @Override
    public ExitCode run(Terminal terminal) {
        checkUsage();
        for (String level : levels) {
            OpenedLevel opened = new LevelName(level).open();
            opened.notice().ifPresent(terminal.err()::println);
            Path file = Path.of(opened.file()).toAbsolutePath();
            if (isLight) {
                bakeLight(file, terminal);
            }
            if (sky != null) {
                bakeSky(opened, file.getParent(), terminal);
            }
        }
        return ExitCode.DONE;
    }

    private void checkUsage() {
        if (sky == null && !isLight) {
            throw CommandFailure.usage("say what to bake: --sky NAME, --light or both");
        }
        if (sky != null && levels.size() > 1) {
            throw CommandFailure.usage("--sky bakes one level; name one, or give --light alone");
        }
        if (lightError != null && !isLight) {
            throw CommandFailure.usage("--light-error needs --light");
        }
        if (sky != null && !sky.matches("[A-Za-z0-9._-]{1,100}")) {
            throw CommandFailure.usage("--sky is a name of letters, digits, '.', '_' and '-', not '" + sky + "'");
        }
    }

    private void bakeLight(Path file, Terminal terminal) {
        LightBake.Settings settings = lightError == null ? null : LightBake.Settings.USUAL.withError(lightError / 100);
        WrittenFile.ofParts(() -> LightBaker.bake(file, settings, terminal.err()))
                .forEach(terminal.out()::println);
    }

    private void bakeSky(OpenedLevel opened, Path folder, Terminal terminal) {
        Level lit = Daylight.lit(opened.level());
        Path target = folder.resolve(sky + ".json");
        if (target.equals(Path.of(opened.file()).toAbsolutePath())) {
            throw CommandFailure.usage("--sky " + sky + " would replace the level itself; choose another name");
        }
        var trace = new SkyboxTrace(opened, eye == null ? start(lit) : eye);
        if (lit.environment().sky() == null && !trace.hasClouds()) {
            throw CommandFailure.input(opened.file() + ": environment.sky: there is no sky to bake; give it one");
        }
        int count = samples != null ? samples : trace.hasClouds() ? USUAL_CLOUDED_SAMPLES : USUAL_SAMPLES;
        TraceSettings settings = SkyboxTrace.settings(side, count);
        List<ResumableTrace.Part> parts = trace.parts(settings, folder, sky);
        BakedSkybox faces = WrittenFile.ofParts(() -> trace.run(parts, settings, terminal.err()));
        write(faces, folder, Daylight.lit(opened.level()));
        parts.forEach(part -> WrittenFile.write(part.file(), file -> part.forget()));
        terminal.out().println(target + " and six pictures of " + side + " pixels");
        if (trace.hasClouds() && lit.environment().sun() != null) {
            terminal.out()
                    .println(String.format(
                            Locale.ROOT, "clouds let %.3g of the sun's light pass to the eye", faces.sunFraction()));
        }
        terminal.out().println(faces.loss());
        if (faces.discPixels() > 0) {
            terminal.out().println("and the sun's disc, which is in " + faces.discPixels() + " pixels");
        }
    }

    private void write(BakedSkybox faces, Path folder, Level lit) {
        for (int face = 0; face < BakedSkybox.FACES; face++) {
            int index = face;
            WrittenFile.write(
                    folder.resolve(BakedSkybox.file(sky, face) + ".png"), to -> Capture.png(faces.picture(index), to));
        }
        try {
            LevelFile.save(folder.resolve(sky + ".json"), faces.usedBy(lit, sky));
        } catch (LevelSaveException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
    }

    private static Vec3 start(Level level) {
        return level.player() == null ? Vec3.ZERO : level.player().feet();
    }
}
