package nephele.lab.trade.subject;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import nephele.engine.render.frame.QualityField;
import nephele.host.draw.QualityChoice;
import nephele.lab.trade.Setting;

/** A setting that changes what is drawn or how. */
record PictureSetting(Setting setting, UnaryOperator<Shot> change) {
    /** Returns the declaration of a setting of quality or of a picture. */
    static QualityField declared(String name) {
        return QualityChoice.FIELDS.stream()
                .filter(field -> field.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no setting " + name));
    }

    /** Returns a value of a setting of quality, named by it; its note are the presets that have it. */
    static PictureSetting of(String name, Object value) {
        return of(name, value, declared(name).presetsWith(value.toString()));
    }

    /** Returns a value of a setting of quality, named by it. */
    static PictureSetting of(String name, Object value, String note) {
        return new PictureSetting(new Setting(value.toString(), note), shot -> shot.set(name, value));
    }

    /** Returns some values of a setting of quality. */
    static List<PictureSetting> all(String name, Object... values) {
        return Stream.of(values).map(value -> of(name, value)).toList();
    }
}
