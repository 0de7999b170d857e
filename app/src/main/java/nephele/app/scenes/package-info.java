/** XML scenes that a user names, opened with all that they show. */
package nephele.app.scenes;
