package nephele.lab.trade;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.lab.bake.TracedPictures;
import nephele.lab.trade.SubjectState.Judged;

/** Measures the subjects one after the other and saves each result, so that an interrupted run can be resumed. */
public final class TradeRun {
    private static final String PARTIAL = "partial";

    private final TradeRequest request;
    private final PrintStream log;
    private final Pictures pictures;
    private final OpenedLevel opened;
    private final TradeView viewpoint;
    private String graphics = "";

    public TradeRun(TradeRequest request, PrintStream log) {
        this.request = request;
        this.log = log;
        pictures = new Pictures(request.folder());
        opened = new LevelName(request.level()).open();
        viewpoint = TradeView.of(opened, request.camera(), request.extent().aspect());
    }

    public OpenedLevel opened() {
        return opened;
    }

    /** Returns a description of the camera in words. */
    public String camera() {
        return viewpoint.camera();
    }

    /** Returns the name of the OpenGL renderer that drew the pictures. */
    public String graphics() {
        return graphics;
    }

    /** Returns the findings of all subjects, in order. */
    public List<Findings> measure() throws IOException {
        Path partial = request.folder().resolve(PARTIAL);
        Files.createDirectories(partial);
        List<Findings> found = new ArrayList<>();
        try (var site = site(partial)) {
            for (Trade trade : request.trades()) {
                found.add(Findings.of(trade, measured(trade, site, partial)));
            }
            graphics = site.graphics();
        }
        return found;
    }

    private TradeSite site(Path partial) {
        return new TradeSite(opened, viewpoint, request.extent(), partial, log);
    }

    /** Returns everything besides the subject that results depend on: results under another key do not count. */
    private String key(Trade trade) {
        String elsewhere =
                trade.level() == null ? "" : " " + TracedPictures.levelHash(new LevelName(trade.level()).open());
        return "code " + Provenance.codeHash() + "; level " + TracedPictures.levelHash(opened) + elsewhere + "; "
                + viewpoint.camera() + "; " + request.extent() + "; slice " + request.sliceSeconds() + "; "
                + Provenance.machine();
    }

    private SubjectState measured(Trade trade, TradeSite site, Path partial) throws IOException {
        var file = new SubjectFile(partial, trade, key(trade), site);
        if (file.isOfAnotherRun()) {
            log.println(trade.subject() + ": what lies in " + partial
                    + " was measured with other code, level, graphics or options; it is measured again");
        }
        SubjectState state = file.load();
        if (state.isComplete(trade, request.rounds()) && pictures.complete(trade, state)) {
            log.println(trade.subject() + ": was measured before");
            return state;
        }
        try (var experiment = trade.experiment().apply(site)) {
            return timed(trade, experiment, judged(trade, experiment, state, file), file);
        }
    }

    private SubjectState judged(Trade trade, Experiment experiment, SubjectState before, SubjectFile file)
            throws IOException {
        SubjectState state = pictures.complete(trade, before) ? before : new SubjectState(List.of(), before.rounds());
        if (state.judged().isEmpty()) {
            pictures.saveExact(trade, experiment.exact());
        }
        for (int setting = state.judged().size(); setting < trade.settings().size(); setting++) {
            log.println(trade.subject() + ": how wrong is "
                    + trade.settings().get(setting).name() + "?");
            var judgement = experiment.judge(setting);
            boolean hasPicture = judgement.picture() != null;
            if (hasPicture) {
                pictures.save(trade, setting, judgement);
            }
            state = state.with(new Judged(judgement.error(), judgement.figures(), hasPicture));
            file.save(state);
        }
        return state;
    }

    private SubjectState timed(Trade trade, Experiment experiment, SubjectState before, SubjectFile file)
            throws IOException {
        SubjectState state = before;
        var clock = new CpuClock(trade.cost().clock());
        var timing = new PairedTiming(experiment, trade.settings().size(), request.sliceSeconds(), clock);
        timing.warmUp();
        while (state.rounds().size() < request.rounds()) {
            int round = state.rounds().size();
            state = state.withRound(timing.round(round));
            file.save(state);
            log.println(trade.subject() + ": timed " + (round + 1) + " of " + request.rounds() + " rounds");
        }
        return state;
    }
}
