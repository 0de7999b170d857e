package nephele.lab.trade;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import nephele.engine.measure.ErrorMap;
import nephele.engine.render.Capture;

/** The files of the report's pictures. */
public final class Pictures {
    private final Path folder;

    public Pictures(Path reportFolder) {
        folder = reportFolder.resolve("pictures");
    }

    Path shown(Trade trade, int setting) {
        return folder.resolve(name(trade, trade.settings().get(setting).name()) + ".png");
    }

    Path error(Trade trade, int setting) {
        return folder.resolve(name(trade, trade.settings().get(setting).name()) + "-flip.png");
    }

    Path exact(Trade trade) {
        return folder.resolve(name(trade, "exact") + ".png");
    }

    private static String name(Trade trade, String setting) {
        return trade.subject() + "-" + setting.replaceAll("[^A-Za-z0-9.]+", "-");
    }

    public void save(Trade trade, int setting, Judgement judgement) throws IOException {
        Capture.png(judgement.shown(), shown(trade, setting));
        Capture.png(heat(judgement.map()), error(trade, setting));
    }

    /** @param picture {@code null} if the subject has no picture */
    public void saveExact(Trade trade, BufferedImage picture) throws IOException {
        if (picture != null) {
            Capture.png(picture, exact(trade));
        }
    }

    /** Returns true if the files of every judged picture still exist. */
    public boolean complete(Trade trade, SubjectState state) {
        return IntStream.range(0, state.judged().size())
                .filter(setting -> state.judged().get(setting).hasPicture())
                .allMatch(setting -> Files.exists(shown(trade, setting))
                        && Files.exists(error(trade, setting))
                        && Files.exists(exact(trade)));
    }

    private static BufferedImage heat(ErrorMap map) {
        var image = new BufferedImage(map.width(), map.height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < map.height(); y++) {
            for (int x = 0; x < map.width(); x++) {
                image.setRGB(x, map.height() - 1 - y, HeatColours.of(map.error()[y * map.width() + x]));
            }
        }
        return image;
    }
}
