package nephele.lab.trade.subject;

import nephele.engine.level.Billboards.Facing;
import nephele.lab.trade.Setting;

/** How the same plants are drawn, in the order of growing cost. */
enum PlantWay {
    SPRITES("sprites", "one picture, turned to the eye"),
    CROSSED("crossed sprites", "two pictures at right angles"),
    IMPOSTORS("impostors", "64 pictures, at every distance"),
    MIXTURE("mixture", "all presets: impostors below 64 pixels, meshes above"),
    MESHES("meshes", "at every distance");

    private static final String FIELD = "impostorPixels";

    private final Setting setting;

    PlantWay(String name, String note) {
        setting = new Setting(name, note);
    }

    Setting setting() {
        return setting;
    }

    PictureSetting of(PlantSprites sprites) {
        return new PictureSetting(setting, shot -> of(shot, sprites));
    }

    private Shot of(Shot shot, PlantSprites sprites) {
        return switch (this) {
            case SPRITES -> shot.with(sprites.in(shot.level(), Facing.CYLINDRICAL));
            case CROSSED -> shot.with(sprites.in(shot.level(), Facing.CROSSED));
            case IMPOSTORS -> shot.set(FIELD, 256);
            case MIXTURE -> shot;
            case MESHES -> shot.set(FIELD, 0);
        };
    }
}
