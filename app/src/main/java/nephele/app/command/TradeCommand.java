package nephele.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import nephele.app.window.Size;
import nephele.engine.asset.AtomicFile;
import nephele.engine.choice.ErrorTable;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.PrintedProgress;
import nephele.host.terminal.Terminal;
import nephele.lab.technique.CloudPages;
import nephele.lab.technique.LevelTable;
import nephele.lab.technique.TableMaker;
import nephele.lab.trade.Circumstances;
import nephele.lab.trade.Provenance;
import nephele.lab.trade.Report;
import nephele.lab.trade.Trade;
import nephele.lab.trade.TradeRequest;
import nephele.lab.trade.TradeRun;
import nephele.lab.trade.TradeSite;
import nephele.lab.trade.subject.Trades;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Measures cost and error of each setting of each subject, and writes a report; a stopped run resumes where it was. */
@picocli.CommandLine.Command
final class TradeCommand implements Command {
    private static final String WITHOUT_LEVEL_TWO = "levels/samples/portals.json";
    private static final int MOST_SAMPLES = 1 << 16;
    private static final int MOST_ROUNDS = 10_000;
    /** Rays a pixel of the pictures from which a level's table of errors comes. */
    private static final int TABLE_SAMPLES = 512;

    private static final int FEW_SAMPLES = 64;

    @Parameters(paramLabel = "SUBJECT", description = "What to measure (default: everything; see --list).")
    private List<String> subjects = List.of();

    @Option(names = "--out", paramLabel = "DIR", description = "Where the report goes, and what is kept for going on.")
    private Path out;

    @Option(
            names = "--level",
            paramLabel = "LEVEL",
            description =
                    "Whose pictures are compared (default: the game's second level); clouds: also whose clouds' table"
                            + " of errors is measured.")
    private String level;

    @Option(
            names = "--camera",
            paramLabel = "ID",
            description = "One of the level's cameras (default: the one that shows most of portals).")
    private String camera;

    @Option(
            names = "--size",
            paramLabel = "WxH",
            description = "Picture in pixels (default: 640x360; 320x180 with --quick).")
    private Size size;

    @Option(names = "--spp", paramLabel = "N", description = "The oracle's rays a pixel (default: 64; 8 with --quick).")
    @OptionRange.Whole(least = 1, most = MOST_SAMPLES)
    private Integer samples;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            description = "Rounds of timing, every setting twice in each (default: 15; 5 with --quick).")
    @OptionRange.Whole(least = 1, most = MOST_ROUNDS)
    private Integer rounds;

    @Option(names = "--quick", description = "Small pictures and few rounds: a look, no figures to quote.")
    private boolean quick;

    @Option(names = "--list", description = "List the subjects and their settings.")
    private boolean list;

    @Override
    public ExitCode run(Terminal terminal) throws Exception {
        if (list) {
            trades().forEach(trade -> {
                terminal.out().println(trade.subject() + ": " + trade.text().title());
                trade.settings().forEach(setting -> terminal.out()
                        .println(("  " + setting.name() + "  " + setting.note()).stripTrailing()));
            });
            return ExitCode.DONE;
        }
        var request = request();
        checkFolder();
        var run = new TradeRun(request, terminal.err());
        if (isOfClouds()) {
            clouds(request, run, terminal);
        } else {
            Report.write(run.measure(), circumstances(request, run), out);
        }
        terminal.out().println(out.resolve("index.html"));
        return ExitCode.DONE;
    }

    private boolean isOfClouds() {
        return subjects.contains(Trades.CLOUDS);
    }

    private List<Trade> trades() {
        return level == null ? Trades.named(subjects) : Trades.ofLevel(subjects);
    }

    private void clouds(TradeRequest request, TradeRun run, Terminal terminal) throws IOException {
        int traced = quick ? FEW_SAMPLES : TABLE_SAMPLES;
        var own = level == null ? null : new LevelTable(run.opened(), level, traced, terminal.err());
        var found = run.measure();
        var table = ErrorTable.shipped();
        if (own != null) {
            terminal.out().println(own.make());
        } else if (!quick) {
            Path file = out.resolve(ErrorTable.FILE);
            var progress = PrintedProgress.of(terminal.err(), "measuring the table of errors");
            table = new TableMaker(file).make(progress);
            terminal.out().println(file + ": copy it to engine/src/main/resources/nephele/engine/choice/ to ship it");
        }
        var extent = request.extent();
        CloudPages.write(out, extent.width(), extent.height(), terminal.err());
        Report.write(found, circumstances(request, run), CloudPages.opening(table), out);
    }

    private TradeRequest request() {
        if (out == null) {
            throw CommandFailure.usage("say where the report goes: --out DIR");
        }
        Size pictures = size != null ? size : quick ? new Size(320, 180) : new Size(640, 360);
        return new TradeRequest(
                trades(),
                level != null ? level : usualLevel(),
                camera,
                new TradeSite.Extent(pictures.width(), pictures.height(), samples != null ? samples : quick ? 8 : 64),
                rounds != null ? rounds : quick ? 5 : 15,
                quick ? 0.03 : 0.15,
                out);
    }

    private static String usualLevel() {
        return LevelCatalogue.campaign().stream()
                .filter(name -> name.fileName().startsWith("02-"))
                .map(LevelName::typed)
                .findFirst()
                .orElse(WITHOUT_LEVEL_TWO);
    }

    private void checkFolder() {
        try {
            Files.createDirectories(out);
        } catch (IOException failure) {
            throw CommandFailure.environment("--out " + out + ": can't be made: " + AtomicFile.reason(failure)
                    + "; name a folder that can be written to");
        }
        if (!Files.isWritable(out)) {
            throw CommandFailure.environment("--out " + out + ": can't be written to; name another folder");
        }
    }

    private Circumstances circumstances(TradeRequest request, TradeRun run) {
        var extent = request.extent();
        boolean isOfSkies = isOfClouds() && level == null;
        String pictures = extent.width() + "×" + extent.height() + " pixels, oracle of " + extent.samples()
                + " rays a pixel" + (isOfSkies ? "" : ", " + run.camera());
        return new Circumstances(
                isOfSkies
                        ? "techniques of clouds"
                        : run.opened().level().name().isEmpty()
                                ? new LevelName(request.level()).title()
                                : run.opened().level().name(),
                isOfSkies ? "skies of the samples" : request.level(),
                pictures,
                Provenance.machine(),
                run.graphics(),
                Provenance.commit(),
                LocalDate.now(ZoneOffset.UTC).toString());
    }
}
