package nephele.app.play;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.app.play.hud.HudContent.Figure;
import nephele.app.settings.GameSetting;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.QualityMemory;
import nephele.app.settings.Settings;
import nephele.engine.level.Language;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.GpuLimits;
import nephele.host.draw.QualityController;
import nephele.host.draw.QualityFront;

/** The quality that holds the player's frame rate while quality is automatic. */
final class AutoQuality {
    private static final double HARDWARE_RATE = 60;
    private static final double SOFTWARE_RATE = 30;

    /** What the frames of a walk usually cost at most, relative to the cheapest of its first view. */
    private static final double WALK_BY_START = 1.4;

    private static final String RESOLUTION = "resolution ";

    private final PlayerFiles files;
    private final boolean software;
    private final String machine;
    private final PrintStream log;
    private final QualityController controller;
    private long lastNanos = System.nanoTime();
    private long levelNanos;
    private String level = "";
    private long pixels;
    private boolean isKnown;

    /** @param log receives a line for each choice; {@code null} for none */
    AutoQuality(PlayerFiles files, GpuLimits limits, PrintStream log) {
        this(files, limits.renderer(), limits.software(), log);
    }

    AutoQuality(PlayerFiles files, String renderer, boolean software, PrintStream log) {
        this.files = files;
        this.software = software;
        this.log = log;
        machine = QualityMemory.machine(renderer);
        controller = new QualityController(QualityFront.of(software), budgetMillis());
    }

    private double budgetMillis() {
        double chosen = files.settings().get(Settings.AUTO_FRAME_RATE);
        double rate = chosen > 0 ? chosen : software ? SOFTWARE_RATE : HARDWARE_RATE;
        return 1000 / rate;
    }

    /** Returns the quality for the next frames; empty if it is not automatic. */
    Optional<Quality> of(PlayRequest request) {
        return request.isQualityAutomatic() ? Optional.of(controller.point().quality()) : Optional.empty();
    }

    /**
     * Returns the quality of the picture behind the title: in software, where it is drawn once and kept, a whole one,
     * whatever the game's quality is.
     */
    Optional<Quality> ofTitle(PlayRequest request) {
        return software ? Optional.of(Quality.HIGH) : of(request);
    }

    /**
     * Begins another level: chooses the point of its first frame by what was learned, if it was drawn on this machine
     * before.
     *
     * @param ofPicture pixels of the window
     */
    void levelBegins(PlayRequest request, long ofPicture) {
        levelEnds();
        level = request.level().key();
        pixels = ofPicture;
        levelNanos = System.nanoTime();
        var known = files.quality().highMillis(machine, level, pixels);
        isKnown = known.isPresent();
        known.ifPresentOrElse(controller::begin, controller::begin);
        report(request, isKnown ? "learned" : "not measured yet");
    }

    /** Returns true if the first view shall be measured: the level was not drawn on this machine before. */
    boolean wantsMeasurement(PlayRequest request) {
        return request.isQualityAutomatic() && !isKnown;
    }

    /**
     * Chooses the point of the first frame by the cost of the first view, and keeps that until the walk tells more; returns
     * true if it is another point.
     *
     * @param millis of the cheapest of a few frames
     */
    boolean firstViewCosts(PlayRequest request, double millis) {
        var before = controller.point();
        isKnown = true;
        double estimate = WALK_BY_START * controller.atHigh(millis);
        controller.begin(estimate);
        learn(estimate);
        report(request, "measured");
        return before != controller.point();
    }

    /** Keeps what was learned of the level. */
    void levelEnds() {
        double learned = controller.learnedHighMillis();
        if (learned > 0 && pixels > 0) {
            learn(learned);
        }
        pixels = 0;
    }

    private void learn(double highMillis) {
        files.keep(files.quality().with(machine, level, pixels, highMillis));
    }

    private void report(PlayRequest request, String why) {
        if (log != null && request.isQualityAutomatic()) {
            log.println(String.format(
                    Locale.ROOT,
                    "quality %s, %s, %.1f s after %s",
                    controller.point().name(),
                    why,
                    (System.nanoTime() - levelNanos) / 1e9,
                    level));
        }
    }

    /**
     * Adds a frame; returns true if another quality shall draw the next one. After a change of the window's size the first
     * frames decide anew.
     */
    boolean frame(PlayRequest request, double millis, long ofPicture) {
        long now = System.nanoTime();
        double seconds = (now - lastNanos) / 1e9;
        lastNanos = now;
        if (!request.isQualityAutomatic()) {
            return false;
        }
        controller.budgetMillis(budgetMillis());
        if (ofPicture != pixels) {
            levelEnds();
            pixels = ofPicture;
            controller.begin();
        }
        boolean isOther = controller.add(millis, seconds);
        if (isOther) {
            report(request, "by the frame rate");
        }
        return isOther;
    }

    /** Returns what the player could do about the quality if it is too slow. */
    SlowAdvice.QualityNow now(PlayRequest request) {
        if (request.isQualityAutomatic()) {
            return controller.isCheapest() ? SlowAdvice.QualityNow.LOWEST : SlowAdvice.QualityNow.ADAPTS;
        }
        String lowest = GameSetting.word(Settings.QualityPreset.LOW);
        if (request.chosenQuality().preset().equalsIgnoreCase(lowest)) {
            return SlowAdvice.QualityNow.LOWEST;
        }
        return request.quality() == null ? SlowAdvice.QualityNow.CAN_BE_LOWERED : SlowAdvice.QualityNow.FIXED_AT_START;
    }

    /** Returns the lines of the panel of figures about the choice. */
    List<Figure> figures(PlayRequest request, Language language) {
        if (!request.isQualityAutomatic()) {
            String preset = name(request.chosenQuality().preset(), language);
            return List.of(new Figure(Phrase.FIGURE_QUALITY.in(language), preset));
        }
        List<Figure> lines = new ArrayList<>();
        lines.add(new Figure(
                Phrase.FIGURE_QUALITY_AUTO.in(language), name(controller.point().name(), language)));
        String slowest = String.format(Locale.ROOT, "%.0f", controller.slowestMillis());
        String budget = String.format(Locale.ROOT, "%.0f", controller.budgetMillis());
        lines.add(new Figure(
                "  " + Phrase.FIGURE_SLOWEST.in(language), Phrase.FIGURE_OF_BUDGET.in(language, slowest, budget)));
        controller
                .better()
                .ifPresent(better -> lines.add(new Figure(
                        "  " + name(better.name(), language),
                        String.format(Locale.ROOT, "%.0f ms", controller.betterMillis()))));
        return lines;
    }

    /**
     * Returns a point of the front, or a preset, in the player's words.
     *
     * @param point {@code high}, or {@code resolution 0.6}
     */
    static String name(String point, Language language) {
        for (Settings.QualityPreset preset : Settings.QualityPreset.values()) {
            if (GameSetting.word(preset).equalsIgnoreCase(point)) {
                return Phrase.ofWord(preset).in(language);
            }
        }
        return point.startsWith(RESOLUTION)
                ? Phrase.RESOLUTION_SHARE.in(language, point.substring(RESOLUTION.length()))
                : point;
    }
}
