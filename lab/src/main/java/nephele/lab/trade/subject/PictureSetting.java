package nephele.lab.trade.subject;

import java.util.function.UnaryOperator;
import nephele.lab.trade.Setting;

/** A setting that changes what is drawn or how. */
record PictureSetting(Setting setting, UnaryOperator<Shot> change) {
    /** Returns a setting of one field of quality, named by the field's value. */
    static PictureSetting of(String field, Object value, String note) {
        return new PictureSetting(new Setting(value.toString(), note), shot -> shot.set(field, value));
    }
}
