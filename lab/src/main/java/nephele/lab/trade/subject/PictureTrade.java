package nephele.lab.trade.subject;

import java.util.List;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Trade;

/** Subjects that change a picture of the level: their error is what the oracle's picture differs by. */
final class PictureTrade {
    static final List<String> FIGURES = List.of("relMSE", "mean bias %", "HDR-FLIP, 99th percentile of pixels");

    private PictureTrade() {}

    static Trade of(String subject, Trade.Text text, List<String> fields, String usual, List<PictureSetting> settings) {
        List<String> names =
                settings.stream().map(setting -> setting.setting().name()).toList();
        return new Trade(
                subject,
                text,
                fields,
                settings.stream().map(PictureSetting::setting).toList(),
                names.indexOf(usual),
                ErrorMetric.PICTURE,
                FIGURES,
                CostMetric.FRAME,
                site -> new PictureExperiment(site, settings, Compared.RADIANCE));
    }
}
