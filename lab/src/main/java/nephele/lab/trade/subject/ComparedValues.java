package nephele.lab.trade.subject;

import java.awt.image.BufferedImage;
import java.util.function.Supplier;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.measure.ErrorMap;
import nephele.engine.measure.Flip;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.engine.render.Capture;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.gl.RenderTarget;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.TradeSite;

/** The values of a picture that are judged, and their reference. */
enum ComparedValues {
    /**
     * Radiance before exposure and tone curve, against the reference picture, which draws no rims: the setting's own error at
     * every exposure.
     */
    RADIANCE(ErrorMetric.PICTURE) {
        @Override
        Shot judged(Shot shot) {
            return shot.with(Output.HDR).set("rims", "off");
        }

        @Override
        LinearPicture read(float[] radiance, RenderTarget picture) {
            return new LinearPicture(picture.width(), picture.height(), radiance);
        }

        @Override
        LinearPicture exact(Supplier<LinearPicture> drawn, TradeSite site) {
            return site.reference();
        }

        @Override
        ErrorMap flip(LinearPicture exact, LinearPicture test) {
            return HdrFlip.of(exact, test);
        }

        @Override
        BufferedImage shown(LinearPicture picture, Environment environment) {
            return Capture.toneMapped(picture.rgb(), picture.width(), environment, Output.DIRECT);
        }
    },
    /** The light that the display emits, against the reference picture's tone-mapped radiance: the picture that a player sees. */
    SEEN(ErrorMetric.DISPLAYED) {
        @Override
        Shot judged(Shot shot) {
            return shot.set("rims", "off");
        }

        @Override
        LinearPicture exact(Supplier<LinearPicture> drawn, TradeSite site) {
            return toneMapped(site.reference(), site.level().environment());
        }
    },
    /** The light that the display emits, against the engine's own radiance tone-mapped in double precision. */
    DISPLAY(ErrorMetric.DISPLAYED) {
        @Override
        Shot judged(Shot shot) {
            return shot;
        }

        @Override
        LinearPicture exact(Supplier<LinearPicture> drawn, TradeSite site) {
            return toneMapped(drawn.get(), site.level().environment());
        }
    };

    private final ErrorMetric error;

    ComparedValues(ErrorMetric error) {
        this.error = error;
    }

    /** Returns the measure of the difference from the reference. */
    ErrorMetric error() {
        return error;
    }

    private static LinearPicture toneMapped(LinearPicture radiance, Environment environment) {
        float[] rgb = radiance.rgb().clone();
        double exposure = Math.pow(2, AutoExposure.stops(environment, rgb, radiance.width()));
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) ToneMapping.toneCurve(Math.max(exposure * rgb[i], 0), environment.toneCurve());
        }
        return new LinearPicture(radiance.width(), radiance.height(), rgb);
    }

    private static BufferedImage encoded(LinearPicture picture) {
        var image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        for (int pixel = 0; pixel < picture.pixels(); pixel++) {
            int code = 0;
            for (int channel = 0; channel < 3; channel++) {
                double shown = ToneMapping.encodeSrgb(picture.rgb()[3 * pixel + channel]);
                code = code << 8 | (int) Math.rint(255 * Math.min(Math.max(shown, 0), 1));
            }
            image.setRGB(pixel % picture.width(), picture.height() - 1 - pixel / picture.width(), code);
        }
        return image;
    }

    /** Returns the shot to judge in place of the shot that is timed. */
    abstract Shot judged(Shot shot);

    /** @param radiance of the judged shot if its output is HDR; otherwise {@code null} */
    LinearPicture read(float[] radiance, RenderTarget picture) {
        return Footage.displayedLight(picture.readBytes(), picture.width(), picture.height(), 1);
    }

    /** @param drawn draws the usual picture's radiance, on request */
    abstract LinearPicture exact(Supplier<LinearPicture> drawn, TradeSite site);

    ErrorMap flip(LinearPicture exact, LinearPicture test) {
        return Flip.ofDisplayed(exact, test);
    }

    BufferedImage shown(LinearPicture picture, Environment environment) {
        return encoded(picture);
    }
}
