/**
 * What a player chose and reached. {@link nephele.app.settings.Settings#ALL} lists the settings, {@link
 * nephele.app.settings.GameSettings} holds their values, {@link nephele.app.settings.Progress} the finished levels; both
 * survive unknown and broken entries of their files. {@link nephele.app.settings.Phrase} holds the game's texts in its languages.
 */
package nephele.app.settings;
