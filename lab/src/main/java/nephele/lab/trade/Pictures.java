package nephele.lab.trade;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import nephele.engine.measure.ErrorMap;
import nephele.engine.render.Capture;

/** The files of the report's pictures. */
public final class Pictures {
    /** Red, green, blue at even steps of error from 0 to 1. */
    private static final int[][] HEAT_STOPS = {
        {0, 0, 4}, {40, 17, 90}, {114, 31, 129}, {183, 55, 121}, {240, 96, 93}, {254, 176, 120}, {252, 253, 191}
    };

    private static final float JPEG_QUALITY = 0.93f;

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
        Capture.png(judgement.picture(), shown(trade, setting));
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
                image.setRGB(x, map.height() - 1 - y, heatColour(map.error()[y * map.width() + x]));
            }
        }
        return image;
    }

    /** Returns a picture as the address of an image element. */
    public static String dataAddress(Path png) throws IOException {
        BufferedImage picture = ImageIO.read(png.toFile());
        var bytes = new ByteArrayOutputStream();
        var writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        try (var stream = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(stream);
            var parameters = writer.getDefaultWriteParam();
            parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            parameters.setCompressionQuality(JPEG_QUALITY);
            writer.write(null, new IIOImage(picture, null, null), parameters);
        } finally {
            writer.dispose();
        }
        return "data:image/jpeg;base64," + Base64.getEncoder().encodeToString(bytes.toByteArray());
    }

    /** @param error clamped to 0–1 */
    static int heatColour(double error) {
        double at = Math.min(Math.max(error, 0), 1) * (HEAT_STOPS.length - 1);
        int stop = Math.min((int) at, HEAT_STOPS.length - 2);
        int colour = 0;
        for (int channel = 0; channel < 3; channel++) {
            double low = HEAT_STOPS[stop][channel];
            double high = HEAT_STOPS[stop + 1][channel];
            colour = colour << 8 | (int) Math.rint(low + (at - stop) * (high - low));
        }
        return colour;
    }

    /** Returns the stops of a CSS gradient, from 0 to 1. */
    static String heatGradient() {
        return Arrays.stream(HEAT_STOPS)
                .map(stop -> "rgb(" + stop[0] + "," + stop[1] + "," + stop[2] + ")")
                .collect(Collectors.joining(","));
    }
}
