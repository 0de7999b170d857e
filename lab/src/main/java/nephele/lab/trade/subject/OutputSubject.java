package nephele.lab.trade.subject;

import java.util.List;
import nephele.engine.render.frame.Output;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** `--output`: where the tone curve is applied. */
public final class OutputSubject {
    private static final List<PictureSetting> SETTINGS = List.of(
            new PictureSetting(
                    new Setting("direct", "surfaces leave their shaders as they are displayed"),
                    shot -> shot.with(Output.DIRECT)),
            new PictureSetting(
                    new Setting("hdr", "half floats first, then one tone-mapping pass"),
                    shot -> shot.with(Output.HDR)));

    public static final Trade TRADE = new Trade(
            "output",
            new Trade.Text(
                    "Where the tone curve is applied",
                    "Direct output applies it in the surfaces' own shaders and saves a whole pass. What is blended"
                        + " over a picture that is display-referred already comes out too bright or too dark. So far"
                        + " only the rims of portals and the ghosts of shots are blended: elsewhere both are equal up"
                        + " to dither.",
                    "the engine's own radiance in linear light, developed in double precision"),
            List.of(),
            SETTINGS.stream().map(PictureSetting::setting).toList(),
            0,
            new ErrorMetric("mean FLIP as displayed", "", 5e-4, 2e-3),
            List.of("relMSE", "mean bias %", "FLIP, 99th percentile of pixels"),
            CostMetric.FRAME,
            site -> new PictureExperiment(site, SETTINGS, Compared.DISPLAY));

    private OutputSubject() {}
}
