/** What failures say to the user, chosen by their types in one place. */
package sunbeam.app.failure;
