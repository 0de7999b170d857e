package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.app.play.hud.HudContent.Figure;
import nephele.app.settings.GameSetting;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.engine.draw.QualityController;
import nephele.engine.draw.QualityFront;
import nephele.engine.render.frame.Quality;

/** The quality that holds the player's frame rate while quality is automatic. */
final class AutoQuality {
    private static final double HARDWARE_RATE = 60;
    private static final double SOFTWARE_RATE = 30;

    private final PlayerFiles files;
    private final boolean software;
    private final QualityController controller;
    private long lastNanos = System.nanoTime();

    AutoQuality(PlayerFiles files, boolean software) {
        this.files = files;
        this.software = software;
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

    /** Begins to measure another level. */
    void levelBegins() {
        controller.begin();
    }

    /** Adds a frame; returns true if another quality shall draw the next one. */
    boolean frame(PlayRequest request, double millis) {
        long now = System.nanoTime();
        double seconds = (now - lastNanos) / 1e9;
        lastNanos = now;
        if (!request.isQualityAutomatic()) {
            return false;
        }
        controller.budgetMillis(budgetMillis());
        return controller.add(millis, seconds);
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
    List<Figure> figures(PlayRequest request) {
        if (!request.isQualityAutomatic()) {
            return List.of(new Figure("quality", request.chosenQuality().preset()));
        }
        var reason = controller.reason();
        List<Figure> lines = new ArrayList<>();
        lines.add(new Figure("quality, auto", controller.point().name()));
        lines.add(new Figure(
                "  slowest",
                String.format(Locale.ROOT, "%.0f of %.0f ms", reason.slowestMillis(), reason.budgetMillis())));
        if (reason.next() != null) {
            lines.add(new Figure(
                    "  " + reason.next().name(), String.format(Locale.ROOT, "%.0f ms", reason.nextMillis())));
        }
        return lines;
    }
}
