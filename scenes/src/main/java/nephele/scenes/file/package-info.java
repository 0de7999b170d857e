/** XML scenes that a user names: opened with their files, or imported as levels. */
package nephele.scenes.file;
